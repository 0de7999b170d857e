package nephele.engine.render.pass.rim;

import java.util.Map;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.MeteredExposure;

/**
 * Draws the membrane in openings with the vertices of {@link nephele.engine.render.resource.OpeningMesh}, for every
 * distance of the eye.
 */
final class OpeningMembrane {
    private static final String FOLDER = "/nephele/engine/render/pass/rim/";

    /** The background is visible through it. */
    private static final double OPACITY = 0.5;

    private record Places(
            Uniforms.Vector4 centreFromEye,
            Uniforms.Vector3 portalRight,
            Uniforms.Vector3 portalUp,
            Uniforms.Vector4 tintAndOpacity,
            Uniforms.Vector4 pattern) {}

    private final GlProgram<Places> program;

    OpeningMembrane(LoadContext context) {
        MeteredExposure.readInViews(context);
        Map<String, String> defines =
                Defines.of(context).with("OPACITY", OPACITY).values();
        program = GlProgram.of(
                context.gl(), FOLDER + "membrane-in-opening.vert", FOLDER + "membrane.frag", defines, Places.class);
    }

    /** Sets the appearance of the openings that are drawn next. */
    void use(RimLook look) {
        program.use();
        Places places = program.uniforms();
        places.centreFromEye.set(
                look.centre.x() - look.view.eyeX(),
                look.centre.y() - look.view.eyeY(),
                look.centre.z() - look.view.eyeZ(),
                0);
        places.portalRight.set(look.frame.right());
        places.portalUp.set(look.frame.up());
        places.tintAndOpacity.set(
                (float) look.tint.x(), (float) look.tint.y(), (float) look.tint.z(), (float) look.opacity);
        places.pattern.set(look.kind, look.cells, (float) look.seconds, (float) look.halfMetres);
    }
}
