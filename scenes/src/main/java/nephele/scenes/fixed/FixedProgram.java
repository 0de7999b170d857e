package nephele.scenes.fixed;

import java.util.Map;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.Matrix4;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.gl.shader.Uniforms.Whole;

/** The program of one kind of shading. */
final class FixedProgram {
    static final String FOLDER = "/nephele/scenes/fixed/";

    private final GlProgram<Inputs> program;

    /**
     * The uniforms.
     *
     * @param towardsViewer {@code null} without lighting
     * @param lightTerms {@code null} without lighting
     */
    record Inputs(
            Whole firstVisible,
            Whole firstPlace,
            Vector3 eye,
            Matrix4 clipFromRelative,
            Vector3 towardsViewer,
            Vector4 lightTerms) {
        static Inputs of(Uniforms uniforms, Shading shading) {
            boolean isLit = shading != Shading.WIREFRAME;
            return new Inputs(
                    uniforms.whole("firstVisible"),
                    uniforms.whole("firstPlace"),
                    uniforms.vector3("eye"),
                    uniforms.matrix4("clipFromRelative"),
                    isLit ? uniforms.vector3("towardsViewer") : null,
                    isLit ? uniforms.vector4("lightTerms") : null);
        }

        boolean isLit() {
            return lightTerms != null;
        }
    }

    FixedProgram(GlContext gl, Shading shading) {
        Map<String, String> defines = Map.of(shading.name(), "1");
        program = new GlProgram<>(
                gl,
                ShaderSource.load(FOLDER + "fixed.vert", defines),
                ShaderSource.load(FOLDER + "fixed.frag", defines),
                uniforms -> Inputs.of(uniforms, shading));
    }

    /** Sets the uniforms that all models of a frame share. */
    Inputs use(EyeNumbers eye, SceneAppearance look) {
        Inputs inputs = program.uniforms();
        program.use();
        inputs.eye().set(eye.x(), eye.y(), eye.z());
        inputs.clipFromRelative().set(eye.clipFromRelative());
        if (inputs.isLit()) {
            inputs.towardsViewer().set(eye.backX(), eye.backY(), eye.backZ());
            inputs.lightTerms()
                    .set(
                            look.term(LightTerm.AMBIENT),
                            look.term(LightTerm.DIFFUSE),
                            look.term(LightTerm.SPECULAR),
                            look.term(LightTerm.EMISSIVE));
        }
        return inputs;
    }
}
