// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";
// States of the run at any time. A position is the number of a frame of the page, or a number between two: 3.25 is a
// quarter of the way from frame 3 to frame 4. app/playback/interpolation.h defines the state there.

function decoded(base64, Type) {
    const text = atob(base64), bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    return new Type(bytes.buffer);
}

// Faces, fragments and looks of a frame, which are stored as changes from the frame before.
class Topology {
    constructor(recording) {
        this.recording = recording;
        this.restart();
    }

    restart() {
        this.frame = 0;
        this.faces = decoded(this.recording.faces, Uint32Array);
        this.fragments = decoded(this.recording.fragments, Uint32Array);
        this.look = this.recording.look ? {} : null;
        for (const name of this.look ? Topology.looks : [])
            this.look[name] = decoded(this.recording.look[name], Uint32Array);
    }

    goTo(frame) {
        if (frame < this.frame) this.restart();
        while (this.frame < frame) {
            const change = this.recording.frames[++this.frame];
            this.faces = Topology.changed(this.faces, decoded(change.corners, Uint32Array));
            this.fragments = Topology.changed(this.fragments, decoded(change.owners, Uint32Array));
            for (const name in this.look)
                this.look[name] = Topology.changed(this.look[name], decoded(change[name], Uint32Array));
        }
        return this;
    }

    // Arrays of the look, of faces and their corners, see app/view/page_look.h.
    static get looks() { return ["texture", "material", "colour"]; }

    // pairs: a place and its new value, alternating. Inserted faces make the array longer.
    static changed(numbers, pairs) {
        let length = numbers.length;
        for (let i = 0; i < pairs.length; i += 2) length = Math.max(length, pairs[i] + 1);
        const result = length == numbers.length ? numbers : new Uint32Array(length);
        if (result !== numbers) result.set(numbers);
        for (let i = 0; i < pairs.length; i += 2) result[pairs[i]] = pairs[i + 1];
        return result;
    }
}

class Playback {
    constructor(recording) {
        this.recording = recording;
        this.earlier = new Topology(recording);
        this.later = new Topology(recording);
        this.unpacked = new Map();
        // Centres of the obstacles, m, in their own frames; obstacles turn about them between frames.
        this.middles = recording.obstacles.map(obstacle => {
            const points = decoded(obstacle.points, Float32Array), middle = new THREE.Vector3();
            for (let i = 0; i < points.length; i += 3) middle.add(new THREE.Vector3().fromArray(points, i));
            return middle.divideScalar(Math.max(1, points.length / 3));
        });
    }

    get last() { return this.recording.frames.length - 1; }

    timeAt(position) {
        const time = this.recording.time, k = Math.floor(position);
        return k < this.last ? time[k] + (position - k) * (time[k + 1] - time[k]) : time[this.last];
    }

    positionAt(time) {
        const times = this.recording.time;
        let k = 0;
        while (k < this.last && times[k + 1] <= time) ++k;
        return k == this.last ? k : k + Math.max(0, (time - times[k]) / (times[k + 1] - times[k]));
    }

    // The arrays of a frame; those of the frames before and after the current position are cached.
    frame(number) {
        if (!this.unpacked.has(number)) {
            const packed = this.recording.frames[number], whole = decoded(packed.position, Uint16Array);
            const place = Float32Array.from(whole, (x, i) => this.recording.low[i % 3] + x * this.recording.step[i % 3]);
            this.unpacked.set(number, { place, lines: decoded(packed.lines, Uint32Array), poses: decoded(packed.poses, Float32Array),
                                        shapes: packed.shapes.map(points => decoded(points, Float32Array)),
                                        scalar: decoded(packed.scalar, Uint8Array), state: decoded(packed.state, Uint8Array),
                                        born: decoded(packed.born, Uint32Array), shares: decoded(packed.shares, Float32Array),
                                        parts: decoded(packed.parts, Uint32Array),
                                        tips: Playback.tipsOf(decoded(packed.tips || "", Float32Array)) });
        }
        return this.unpacked.get(number);
    }

    // The state at a position. frame: number of the frame before; faces, fragments and their look (or null); place (m),
    // scalar and state of vertices; lines; poses of obstacles, shapes: points (m) of deforming ones; tips of cracks.
    at(position) {
        const number = Math.min(this.last, Math.max(0, Math.floor(position))), share = position - number;
        for (const known of this.unpacked.keys()) if (known < number || known > number + 1) this.unpacked.delete(known);
        const { faces, fragments, look } = this.earlier.goTo(number), from = this.frame(number);
        if (!(share > 0) || number == this.last)
            return { ...from, frame: number, share: 0, faces, fragments, look, place: from.place.slice() };
        const to = this.frame(number + 1), { faces: later, look: paint } = this.later.goTo(number + 1);
        const before = Playback.before(faces, later, to, from.place.length / 3);
        const places = Playback.carried(from.place, 3, before, to), scalars = Playback.carried(from.scalar, 1, before, to);
        const place = to.place.map((x, i) => places[i] + share * (x - places[i]));
        const scalar = to.scalar.map((x, v) => Math.round(scalars[v] + share * (x - scalars[v])));
        const state = to.state.map((_, v) => from.state[before[v]]);
        const owners = Uint32Array.from({ length: later.length / 3 }, (_, f) => fragments[f]);
        for (let i = 0; i < to.parts.length; i += 2) owners[to.parts[i]] = fragments[to.parts[i + 1]];
        const poses = this.middles.flatMap((middle, i) => Playback.poseBetween(from.poses, to.poses, i, share, middle));
        const shapes = from.shapes.map((points, i) => points.map((x, k) => x + share * (to.shapes[i][k] - x)));
        const tips = Playback.tipsBetween(from.tips, to.tips, share);
        return { frame: number, share, faces: later, fragments: owners, look: paint, place, scalar, state, lines: to.lines, poses, shapes,
                 tips };
    }

    // Tips of cracks, in SI units; share: G / G_c.
    static tipsOf(packed) {
        const names = ["number", "x", "y", "z", "dx", "dy", "dz", "speed", "share", "K_I", "K_II", "k_1", "k_2"], tips = [];
        for (let i = 0; i < packed.length; i += names.length)
            tips.push(Object.fromEntries(names.map((name, k) => [name, packed[i + k]])));
        return tips;
    }

    // The tips of the earlier frame, moving to their places in the later one if they still exist there.
    static tipsBetween(from, to, share) {
        return from.map(tip => {
            const end = to.find(other => other.number == tip.number) || tip, place = {};
            for (const x of ["x", "y", "z"]) place[x] = tip[x] + share * (end[x] - tip[x]);
            return { ...tip, ...place };
        });
    }

    // The earlier frame's vertex for each vertex of the later one, found by the corners of faces, which stay. A vertex
    // that was inserted since then lies between three parents; the parent with the largest weight stands for it.
    static before(earlierFaces, laterFaces, later, earlierCount) {
        const before = Uint32Array.from({ length: later.place.length / 3 }, (_, v) => Math.min(v, earlierCount - 1));
        for (let i = 0; i < earlierFaces.length; ++i) before[laterFaces[i]] = earlierFaces[i];
        for (let i = 0; i < later.born.length; i += 4) {
            const shares = later.shares.subarray(i / 4 * 3, i / 4 * 3 + 3);
            before[later.born[i]] = later.born[i + 1 + shares.indexOf(Math.max(...shares))];
        }
        return before;
    }

    // Values of the earlier frame's vertices, `width` for each, at the vertices of the later one.
    static carried(values, width, before, later) {
        const result = new Float32Array(width * before.length);
        before.forEach((from, v) => { for (let x = 0; x < width; ++x) result[width * v + x] = values[width * from + x]; });
        for (let i = 0; i < later.born.length; i += 4)
            for (let x = 0; x < width; ++x) {
                let sum = 0;
                for (let k = 0; k < 3; ++k) sum += later.shares[i / 4 * 3 + k] * values[width * later.born[i + 1 + k] + x];
                result[width * later.born[i] + x] = sum;
            }
        return result;
    }

    static poseBetween(from, to, number, share, middle) {
        const ends = [from, to].map(poses => poses.subarray(16 * number, 16 * number + 16));
        if (!ends.every(end => end.every(Number.isFinite))) return [...ends[0]];
        const [a, b] = ends.map(end => new THREE.Matrix4().fromArray(end));
        const turn = new THREE.Quaternion().setFromRotationMatrix(a);
        turn.slerp(new THREE.Quaternion().setFromRotationMatrix(b), share);
        const place = middle.clone().applyMatrix4(a).lerp(middle.clone().applyMatrix4(b), share);
        place.sub(middle.clone().applyQuaternion(turn));
        return new THREE.Matrix4().makeRotationFromQuaternion(turn).setPosition(place.x, place.y, place.z).toArray();
    }
}
