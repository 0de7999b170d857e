package nephele.engine.render.pass.particle;

import java.nio.FloatBuffer;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.Emitter;
import nephele.engine.particle.BackToFront;
import nephele.engine.particle.LevelParticles;
import nephele.engine.particle.ParticleArrays;
import nephele.engine.particle.ParticlePicture;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.resource.AmbientLight;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.render.resource.SquareSheet;
import nephele.engine.scene.View;

/**
 * Draws the particles of all emitters in each view: evaluated for the frame's time, sorted for the view's eye, and
 * blended over the view. Places are subtracted in double precision, so the world's size does not matter.
 */
public final class ParticlePass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "particle", Stage.IN_VIEWS_AFTER_OPAQUE, ParticlePass::requiredBy)
            .using(
                    RendererClouds.RESOURCE,
                    FrameLightning.RESOURCE,
                    AmbientLight.RESOURCE,
                    AmbientLight.PROBES,
                    MeteredExposure.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/particle/";
    private static final int PER_SHEET = 512;
    /** Three texels for each particle, see {@code particle.vert}. */
    private static final int FLOATS = 12;

    private record PixelUniforms(Scalar pixelPerMetre) {}

    private final GlContext gl;
    private final Map<Target, Texture> targets;
    private final TargetReads reads;
    private final LevelParticles particles;
    private final ParticleLight light;
    private final GlProgram<PixelUniforms> program;
    /** {@code null} if all kinds are drawn by formulas. */
    private final Texture pictures;

    private final SquareSheet squares;
    private final BackToFront order = new BackToFront();
    private final boolean[] isVisible;
    /** The vectors from the eye to the centres of the emitters, three values each. */
    private final float[] centres;

    private ParticlePass(LoadContext context) {
        gl = context.gl();
        targets = context.targets();
        reads = context.request().fadesAtSurfaces() ? TargetReads.of(Target.VIEW_DEPTH) : TargetReads.of();
        List<Emitter> emitters = making(context.request());
        particles = new LevelParticles(emitters, context.scene().statics());
        light = new ParticleLight(context, particles);
        isVisible = new boolean[emitters.size()];
        centres = new float[3 * emitters.size()];
        squares = context.own(new SquareSheet(gl, "particles", PER_SHEET, FLOATS, 1));
        MeteredExposure.readInViews(context);
        boolean arePictured = emitters.stream().anyMatch(emitter -> isPictured(emitter.kind()));
        pictures = arePictured ? context.own(ParticlePictures.texture(gl)) : null;
        Map<String, String> defines = Defines.of(context)
                .withIf(context.request().fadesAtSurfaces(), "SURFACES")
                .withIf(arePictured, "PICTURES")
                .with("PER_SHEET", PER_SHEET)
                .with("STREAK", ParticlePicture.STREAK.first())
                .with("BILLOW", ParticlePicture.BILLOW.first())
                .with("TONGUE", ParticlePicture.TONGUE.first())
                .values();
        program = GlProgram.of(gl, FOLDER + "particle.vert", FOLDER + "particle.frag", defines, PixelUniforms.class);
    }

    private static boolean isPictured(Emitter.Kind kind) {
        return switch (kind) {
            case FIRE, SMOKE, EXPLOSION, QUADS -> true;
            case RAIN, SNOW, SPARKS -> false;
        };
    }

    private static List<Emitter> making(FrameRequest request) {
        return request.level().emitters().stream()
                .filter(emitter -> emitter.ratePerSecond() > 0)
                .toList();
    }

    private static List<Required> requiredBy(FrameRequest request) {
        int making = making(request).size();
        return making == 0
                ? List.of()
                : List.of(new Required("emitters: " + making + " make particles", ParticlePass::new));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public boolean needsCopies(FrameContext frame) {
        return findVisible(frame);
    }

    /** Finds the emitters that a view may see; returns true if there is one. */
    private boolean findVisible(FrameContext frame) {
        boolean any = false;
        particles.follow(frame.frameState().portals());
        for (int i = 0; i < isVisible.length; i++) {
            isVisible[i] = frame.frustum().mayIntersect(particles.bounds(i));
            any |= isVisible[i];
        }
        return any;
    }

    @Override
    public void draw(FrameContext frame) {
        if (!findVisible(frame)) {
            return;
        }
        ParticleArrays all = particles.at(frame.frameState().seconds());
        light.follow(frame.frameState().environment());
        sort(all, frame.view());
        if (order.count() == 0) {
            return;
        }
        FloatBuffer texels = squares.staging(order.count()).clear();
        for (int i = 0; i < order.count(); i++) {
            put(all.numbers(), ParticleArrays.STRIDE * order.at(i), texels, FLOATS * i);
        }
        frame.surface().bind();
        gl.state().set(Depth.LESS_OR_EQUAL, Blend.COVER, Cull.NONE, frame.clipDistances());
        reads.bind(targets);
        program.use();
        double height = 2 * frame.view().projection().tanHalfHeight();
        program.uniforms().pixelPerMetre().set(height / frame.surface().height());
        if (pictures != null) {
            pictures.bind(TextureUnit.COLOURS);
        }
        squares.draw(order.count(), 0, TextureUnit.DYNAMIC_INSTANCES);
    }

    private void sort(ParticleArrays all, View view) {
        for (int i = 0; i < isVisible.length; i++) {
            var centre = particles.emitters().get(i).centre();
            centres[3 * i] = (float) (centre.x() - view.eyeX());
            centres[3 * i + 1] = (float) (centre.y() - view.eyeY());
            centres[3 * i + 2] = (float) (centre.z() - view.eyeZ());
        }
        float backX = (float) view.back().x();
        float backY = (float) view.back().y();
        float backZ = (float) view.back().z();
        float[] n = all.numbers();
        order.begin(all.count());
        for (int i = 0; i < all.count(); i++) {
            int at = ParticleArrays.STRIDE * i;
            int emitter = (int) n[at + ParticleArrays.EMITTER];
            if (isVisible[emitter]) {
                float x = centres[3 * emitter] + n[at];
                float y = centres[3 * emitter + 1] + n[at + 1];
                float z = centres[3 * emitter + 2] + n[at + 2];
                if (x * backX + y * backY + z * backZ < reach(n, at)) {
                    order.add(i, x * x + y * y + z * z);
                }
            }
        }
        order.sort();
    }

    /** Returns a bound of the distance from a particle's middle to its corners. */
    private static float reach(float[] n, int at) {
        return 1.5f * n[at + ParticleArrays.HALF_WIDTH]
                + Math.abs(n[at + ParticleArrays.ALONG_X])
                + Math.abs(n[at + ParticleArrays.ALONG_Y])
                + Math.abs(n[at + ParticleArrays.ALONG_Z]);
    }

    /** Writes a particle as {@code particle.vert} reads it, with its place from the eye and the light that it scatters. */
    private void put(float[] n, int at, FloatBuffer out, int to) {
        int emitter = (int) n[at + ParticleArrays.EMITTER];
        float lit = n[at + ParticleArrays.ALBEDO] * n[at + ParticleArrays.OPACITY];
        for (int i = 0; i < 3; i++) {
            out.put(to + i, centres[3 * emitter + i] + n[at + i]);
            int colour = ParticleArrays.RED + i;
            out.put(to + colour, n[at + colour] + lit * light.radiance(emitter, i));
        }
        out.put(to + ParticleArrays.HALF_WIDTH, n[at + ParticleArrays.HALF_WIDTH]);
        out.put(to + ParticleArrays.OPACITY, n[at + ParticleArrays.OPACITY]);
        float look = n[at + ParticleArrays.LOOK];
        out.put(to + ParticleArrays.LOOK, look);
        boolean isBillow = look >= ParticlePicture.BILLOW.first() && look < ParticlePicture.TONGUE.first();
        for (int axis = 0; axis < 3; axis++) {
            int along = ParticleArrays.ALONG_X + axis;
            out.put(to + along, isBillow ? light.relief(emitter, axis) : n[at + along]);
        }
    }
}
