package nephele.engine.render.pass.rim;

import java.util.Map;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.resource.MeteredExposure;

/** The programs of a rim's parts; all have the same uniforms. */
final class RimPrograms {
    private static final String FOLDER = "/nephele/engine/render/pass/rim/";

    private static final double OPACITY_OVER_WALL = 0.93;

    private final GlProgram<Placing> ring;
    private final GlProgram<Placing> glow;
    private final GlProgram<Placing> membrane;

    RimPrograms(LoadContext context) {
        MeteredExposure.readInViews(context);
        ring = program(context, "ring.frag", Defines.of(context));
        glow = program(context, "glow.frag", Defines.of(context));
        membrane = program(context, "membrane.frag", Defines.of(context).with("OPACITY", OPACITY_OVER_WALL));
    }

    private static GlProgram<Placing> program(LoadContext context, String fragment, Defines names) {
        Map<String, String> defines = names.values();
        return GlProgram.of(context.gl(), FOLDER + "rim.vert", FOLDER + fragment, defines, Placing.class);
    }

    GlProgram<Placing> ring() {
        return ring;
    }

    GlProgram<Placing> glow() {
        return glow;
    }

    GlProgram<Placing> membrane() {
        return membrane;
    }

    /** The uniforms for the pose and appearance of one portal. */
    record Placing(
            Vector4 centreAndOpenness,
            Vector3 portalRight,
            Vector3 portalUp,
            Vector3 portalBack,
            Vector4 tintAndOpacity,
            Vector4 pattern) {
        void set(RimLook look) {
            centreAndOpenness.set(
                    look.centre.x() - look.view.eyeX(),
                    look.centre.y() - look.view.eyeY(),
                    look.centre.z() - look.view.eyeZ(),
                    look.openness);
            portalRight.set(look.frame.right());
            portalUp.set(look.frame.up());
            portalBack.set(look.frame.back());
            tintAndOpacity.set(look.tint.x(), look.tint.y(), look.tint.z(), look.opacity);
            pattern.set(look.kind, look.cells, look.seconds, look.halfMetres);
        }
    }
}
