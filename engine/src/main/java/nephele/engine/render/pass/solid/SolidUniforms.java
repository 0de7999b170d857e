package nephele.engine.render.pass.solid;

import nephele.engine.math.Vec3;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Vector3;

/** The uniforms that change from batch to batch. */
record SolidUniforms(Vector3 eyeHigh, Vector3 eyeLow, @IfRead Vector3 cellFromAnchor) {
    void eye(float[] highAndLow) {
        eyeHigh.set(highAndLow[0], highAndLow[1], highAndLow[2]);
        eyeLow.set(highAndLow[3], highAndLow[4], highAndLow[5]);
    }

    void cell(Vec3 origin, Vec3 anchor) {
        cellFromAnchor.set(origin.minus(anchor));
    }
}
