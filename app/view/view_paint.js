// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";
// Draws sheets with the materials, pictures and colours of their mesh files. Colours of vertices multiply the
// material's.

function sheetMaterial(rgb) {
    return new THREE.MeshLambertMaterial({ color: rgb, vertexColors: THREE.VertexColors, side: THREE.DoubleSide,
                                           polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
}

class Paint {
    // look: materials as pairs of a colour and the number of a picture, or -1; pictures as URLs. redraw: called when a
    // picture has been loaded; until then the material's colour replaces it.
    constructor(look, redraw) {
        this.materials = [...look.materials.map(([rgb]) => sheetMaterial(rgb)), sheetMaterial(0xcebfab)];
        this.broken = this.materials.length - 1;  // material of crack faces, which have no picture
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

    // Turns an indexed geometry into one with triangles sorted by material; returns it with the triangles' fragments.
    // corners: for each corner of a triangle, the corner of a face, or -1 on a crack face.
    painted(indexed, corners, fragments, look) {
        const { order, starts } = this.byMaterial(corners, fragments.length, look);
        const places = new Uint32Array(corners.length), shown = new Int32Array(corners.length);
        for (let i = 0; i < places.length; ++i) {
            const from = 3 * order[Math.floor(i / 3)] + i % 3;
            places[i] = indexed.index.array[from];
            shown[i] = corners[from];
        }
        const geometry = new THREE.BufferGeometry();
        for (const name of ["position", "normal"]) {
            const values = Paint.taken(indexed.getAttribute(name).array, 3, places);
            geometry.setAttribute(name, new THREE.BufferAttribute(values, 3));
        }
        indexed.dispose();
        const uv = look.texture.length > 0 ? Paint.taken(new Float32Array(look.texture.buffer), 2, shown)
                                           : new Float32Array(2 * shown.length);
        geometry.setAttribute("uv", new THREE.BufferAttribute(uv, 2));
        geometry.setAttribute("color", new THREE.BufferAttribute(Paint.colours(shown, look), 3));
        for (let m = 0; m < this.materials.length; ++m)
            if (starts[m + 1] > starts[m]) geometry.addGroup(3 * starts[m], 3 * (starts[m + 1] - starts[m]), m);
        return [geometry, Array.from(order, t => fragments[t])];
    }

    // Triangle numbers sorted by material, and the start of each material among them.
    byMaterial(corners, count, look) {
        const material = t => corners[3 * t] < 0 ? this.broken : look.material[Math.floor(corners[3 * t] / 3)];
        const starts = new Uint32Array(this.materials.length + 1), order = new Uint32Array(count);
        for (let t = 0; t < count; ++t) ++starts[material(t) + 1];
        for (let m = 0; m < this.materials.length; ++m) starts[m + 1] += starts[m];
        const next = starts.slice();
        for (let t = 0; t < count; ++t) order[next[material(t)]++] = t;
        return { order, starts };
    }

    // Picks `width` values for each of the places; 0 for -1.
    static taken(values, width, places) {
        const result = new Float32Array(width * places.length);
        for (let i = 0; i < places.length; ++i)
            if (places[i] >= 0) for (let k = 0; k < width; ++k) result[width * i + k] = values[width * places[i] + k];
        return result;
    }

    static colours(corners, look) {
        const result = new Float32Array(3 * corners.length).fill(1);
        if (look.colour.length == 0) return result;
        for (let i = 0; i < corners.length; ++i)
            if (corners[i] >= 0) for (let k = 0; k < 3; ++k) result[3 * i + k] = (look.colour[corners[i]] >> 8 * k & 255) / 255;
        return result;
    }
}
