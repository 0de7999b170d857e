package nephele.engine.render.pass.solid;

import nephele.engine.render.gl.Uniforms.Vector3;

/** What changes from batch to batch. */
record SolidUniforms(Vector3 eyeHigh, Vector3 eyeLow) {
    void eye(float[] highAndLow) {
        eyeHigh.set(highAndLow[0], highAndLow[1], highAndLow[2]);
        eyeLow.set(highAndLow[3], highAndLow[4], highAndLow[5]);
    }
}
