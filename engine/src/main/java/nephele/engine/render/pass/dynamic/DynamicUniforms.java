package nephele.engine.render.pass.dynamic;

import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.resource.DynamicMeshes.RunUniforms;

/** The uniforms that change from view to view and from run to run. */
record DynamicUniforms(
        Vector3 eyeHigh, Vector3 eyeLow, @IfRead Scalar seamPerMetre, @IfRead Scalar clarity, RunUniforms run) {
    void view(float[] highAndLow, float seam, float heldClarity) {
        eyeHigh.set(highAndLow[0], highAndLow[1], highAndLow[2]);
        eyeLow.set(highAndLow[3], highAndLow[4], highAndLow[5]);
        seamPerMetre.set(seam);
        clarity.set(heldClarity);
    }
}
