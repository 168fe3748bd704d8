// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";
// Sheets as the files of their meshes paint them. Colours of vertices multiply those of the material.

function sheetMaterial(rgb) {
    return new THREE.MeshLambertMaterial({ color: rgb, vertexColors: THREE.VertexColors, side: THREE.DoubleSide,
                                           polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
}

class Paint {
    // look: materials as pairs of a colour and the number of a picture, or -1; pictures as URLs. redraw: is called when
    // one is there; until then the colour stands for it.
    constructor(look, redraw) {
        this.materials = [...look.materials.map(([rgb]) => sheetMaterial(rgb)), sheetMaterial(0xcebfab)];
        this.broken = this.materials.length - 1;  // where a sheet broke, no picture goes on
        this.loaded = 0;
        look.pictures.forEach((url, number) => new THREE.TextureLoader().load(url, picture => {
            picture.wrapS = picture.wrapT = THREE.RepeatWrapping;
            picture.anisotropy = 4;
            ++this.loaded;
            look.materials.forEach(([, shown], i) => {
                if (shown == number) Object.assign(this.materials[i], { map: picture, needsUpdate: true }).color.set(0xffffff);
            });
            redraw();
        }));
    }

    // A geometry of triangles by material, and their fragments, of an indexed one. corners: of each corner of a
    // triangle, that of a face, or -1 where it broke.
    painted(indexed, corners, fragments, look) {
        const byMaterial = this.materials.map(() => []);
        fragments.forEach((_, t) => {
            const face = Math.floor(corners[3 * t] / 3);
            byMaterial[face < 0 ? this.broken : look.material[face]].push(t);
        });
        const order = byMaterial.flat(), places = order.flatMap(t => [3 * t, 3 * t + 1, 3 * t + 2]);
        indexed.setIndex(new THREE.BufferAttribute(Uint32Array.from(places, i => indexed.index.array[i]), 1));
        const geometry = indexed.toNonIndexed(), [texture, colour] = Paint.attributes(places.map(i => corners[i]), look);
        indexed.dispose();
        geometry.setAttribute("uv", new THREE.BufferAttribute(texture, 2));
        geometry.setAttribute("color", new THREE.BufferAttribute(colour, 3));
        let start = 0;
        byMaterial.forEach((triangles, material) => {
            if (triangles.length > 0) geometry.addGroup(start, 3 * triangles.length, material);
            start += 3 * triangles.length;
        });
        return [geometry, order.map(t => fragments[t])];
    }

    static attributes(corners, look) {
        const recorded = new Float32Array(look.texture.buffer);
        const texture = new Float32Array(2 * corners.length), colour = new Float32Array(3 * corners.length).fill(1);
        corners.forEach((corner, i) => {
            if (corner < 0) return;
            if (recorded.length > 0) texture.set(recorded.subarray(2 * corner, 2 * corner + 2), 2 * i);
            if (look.colour.length == 0) return;
            for (let k = 0; k < 3; ++k) colour[3 * i + k] = (look.colour[corner] >> 8 * k & 255) / 255;
        });
        return [texture, colour];
    }
}
