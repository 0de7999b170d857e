package nephele.engine.render.pass.rim;

import java.util.Map;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/**
 * Draws the membrane in openings with the vertices of {@link nephele.engine.render.resource.OpeningMesh}, for every
 * distance of the eye.
 */
final class OpeningMembrane {
    private static final String FOLDER = "/nephele/engine/render/pass/rim/";

    /** The background is visible through it. */
    private static final double OPACITY = 0.5;

    private record Places(
            Uniforms.Vector4 centre,
            Uniforms.Vector3 right,
            Uniforms.Vector3 up,
            Uniforms.Vector4 tint,
            Uniforms.Vector4 pattern) {}

    private final GlProgram<Places> program;

    OpeningMembrane(LoadContext context) {
        Map<String, String> defines =
                Defines.of(context).with("OPACITY", OPACITY).values();
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "membrane-in-opening.vert", defines),
                ShaderSource.load(FOLDER + "membrane.frag", defines),
                uniforms -> {
                    MeteredExposure.tieInView(context, uniforms);
                    return new Places(
                            uniforms.vector4("centreFromEye"),
                            uniforms.vector3("portalRight"),
                            uniforms.vector3("portalUp"),
                            uniforms.vector4("tintAndOpacity"),
                            uniforms.vector4("pattern"));
                });
    }

    /** Sets the appearance of the openings that are drawn next. */
    void use(RimLook look) {
        program.use();
        Places places = program.uniforms();
        places.centre.set(
                (float) (look.centre.x() - look.view.eyeX()),
                (float) (look.centre.y() - look.view.eyeY()),
                (float) (look.centre.z() - look.view.eyeZ()),
                0);
        set(places.right, look.frame.right());
        set(places.up, look.frame.up());
        places.tint.set((float) look.tint.x(), (float) look.tint.y(), (float) look.tint.z(), (float) look.opacity);
        places.pattern.set(look.kind, look.cells, (float) look.seconds, (float) look.halfMetres);
    }

    private static void set(Uniforms.Vector3 uniform, Vec3 v) {
        uniform.set((float) v.x(), (float) v.y(), (float) v.z());
    }
}
