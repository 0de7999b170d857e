package nephele.engine.render.pass.particle;

import java.util.List;
import nephele.engine.level.Emitter;
import nephele.engine.particle.ParticlePicture;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.MeteredExposure;

/** The shaders of particles, with the pictures that the level's kinds need. */
final class ParticleProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/particle/";

    private final GlProgram<Places> program;
    /** {@code null} if all kinds are drawn by formulas. */
    private final Texture pictures;

    private record Places(Uniforms.Scalar pixelPerMetre) {}

    /** @param meetSurfaces whether particles fade where they meet surfaces */
    ParticleProgram(LoadContext context, List<Emitter> emitters, boolean meetSurfaces) {
        GlContext gl = context.gl();
        MeteredExposure.readInViews(context);
        boolean pictured = emitters.stream().anyMatch(emitter -> isPictured(emitter.kind()));
        var defines = Defines.of(context)
                .withIf(meetSurfaces, "SURFACES")
                .withIf(pictured, "PICTURES")
                .with("PER_SHEET", ParticleQuads.PER_SHEET)
                .with("STREAK", ParticlePicture.STREAK.first())
                .with("BILLOW", ParticlePicture.BILLOW.first())
                .with("TONGUE", ParticlePicture.TONGUE.first())
                .values();
        pictures = pictured ? context.own(ParticlePictures.texture(gl)) : null;
        program = GlProgram.of(gl, FOLDER + "particle.vert", FOLDER + "particle.frag", defines, Places.class);
    }

    private static boolean isPictured(Emitter.Kind kind) {
        return switch (kind) {
            case FIRE, SMOKE, EXPLOSION, QUADS -> true;
            case RAIN, SNOW, SPARKS -> false;
        };
    }

    void use(FrameContext frame) {
        program.use();
        double height = 2 * frame.view().projection().tanHalfHeight();
        program.uniforms().pixelPerMetre().set((float) (height / frame.surface().height()));
        if (pictures != null) {
            pictures.bind(TextureUnit.COLOURS);
        }
    }
}
