package nephele.engine.render.pass.portal;

import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.OpeningMesh;
import nephele.engine.scene.ViewNode;
import org.joml.Vector3dc;

/**
 * Adds the fog in front of a tinted mirror to its reflection. A surface's radiance is tinted together with all fog in
 * front of it; this adds what the tint removed from the fog on this side, in linear light.
 */
final class MirrorFog {
    private final GlContext gl;
    private final OpeningMesh openings;
    private final GlProgram<Uniforms.Vector3> program;

    private MirrorFog(LoadContext context) {
        gl = context.gl();
        openings = context.get(OpeningMesh.RESOURCE);
        program = OpeningPrograms.fog(context);
    }

    /** Returns {@code null} if no fog is in front of mirrors, or if the output has no linear light to add to. */
    static MirrorFog of(LoadContext context) {
        boolean isFoggy =
                FogTransmittance.of(context.scene().level().environment()).isPresent();
        return isFoggy
                        && context.output() != Output.DIRECT
                        && !context.scene().mirrors().isEmpty()
                ? new MirrorFog(context)
                : null;
    }

    /** Draws over a filled opening whose own depth is the nearest. */
    void draw(ViewNode child) {
        Vec3 kept = child.opening().tint();
        if (kept.x() == 1 && kept.y() == 1 && kept.z() == 1) {
            return;
        }
        Vector3dc before = child.parent().view().tint();
        program.uniforms().set((float) (before.x() * (1 - kept.x())), (float) (before.y() * (1 - kept.y())), (float)
                (before.z() * (1 - kept.z())));
        gl.state().set(Depth.EQUAL, Blend.ADD, Cull.NONE);
        program.use();
        openings.draw(child);
    }
}
