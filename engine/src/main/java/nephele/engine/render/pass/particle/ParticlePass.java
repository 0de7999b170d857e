package nephele.engine.render.pass.particle;

import java.nio.FloatBuffer;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Emitter;
import nephele.engine.math.Frustum;
import nephele.engine.particle.BackToFront;
import nephele.engine.particle.LevelParticles;
import nephele.engine.particle.ParticleArrays;
import nephele.engine.particle.ParticlePicture;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.View;
import nephele.engine.scene.light.LightRequirements;
import org.joml.Matrix4d;

/**
 * Draws the particles of all emitters in each view: evaluated for the frame's time, sorted for the view's eye, and
 * blended over the view. Places are subtracted in double precision, so the world's size does not matter.
 */
public final class ParticlePass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("particle", Stage.IN_VIEWS_AFTER_OPAQUE, ParticlePass::requiredBy);

    private final GlContext gl;
    private final SharedResources shared;
    private final TargetReads reads;
    private final LevelParticles particles;
    private final ParticleLight light;
    private final ParticleProgram program;
    private final ParticleQuads quads;
    private final BackToFront order = new BackToFront();
    private final Frustum whole = Frustum.reusable(6);
    private final Matrix4d clipFromRelative = new Matrix4d();
    private final boolean[] isSeen;
    /** From the eye to the centres of the emitters. */
    private final float[] centres;

    private ParticlePass(LoadContext context) {
        gl = context.gl();
        shared = context.shared();
        reads = meetSurfaces(context.request()) ? TargetReads.of(Target.VIEW_DEPTH) : TargetReads.of();
        List<Emitter> emitters = making(context.request());
        particles = new LevelParticles(emitters, context.scene().statics());
        light = new ParticleLight(context.scene().level(), particles, shared);
        isSeen = new boolean[emitters.size()];
        centres = new float[3 * emitters.size()];
        quads = context.own(new ParticleQuads(gl));
        program = new ParticleProgram(context, emitters, meetSurfaces(context.request()));
    }

    private static List<Emitter> making(FrameRequest request) {
        return request.level().emitters().stream()
                .filter(emitter -> emitter.ratePerSecond() > 0)
                .toList();
    }

    /** Returns false if there is nothing by which particles could be cut. */
    private static boolean meetSurfaces(FrameRequest request) {
        return LightRequirements.hasSurfaces(request.level()) || request.hasBodies() || request.mayShowCharacter();
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
        return findSeen(frame);
    }

    /** Finds the emitters that a view may see; returns true if there is one. */
    private boolean findSeen(FrameContext frame) {
        boolean any = false;
        for (int i = 0; i < isSeen.length; i++) {
            isSeen[i] = limits(frame).mayIntersect(particles.bounds(i));
            any |= isSeen[i];
        }
        return any;
    }

    private Frustum limits(FrameContext frame) {
        if (frame.limits() != null) {
            return frame.limits();
        }
        View view = frame.view();
        whole.restart(view.eyeX(), view.eyeY(), view.eyeZ());
        whole.keepAll(view.clipFromRelative(clipFromRelative));
        return whole;
    }

    @Override
    public void draw(FrameContext frame) {
        if (!findSeen(frame)) {
            return;
        }
        ParticleArrays all = particles.at(frame.frameState().seconds());
        light.follow(frame.frameState().environment());
        sort(all, frame.view());
        if (order.count() == 0) {
            return;
        }
        quads.begin(order.count());
        for (int i = 0; i < order.count(); i++) {
            put(all, order.at(i), quads.next());
        }
        frame.surface().bind();
        gl.state().set(Depth.LESS_OR_EQUAL, Blend.PREMULTIPLIED_OVER, Cull.NONE, frame.clipDistances());
        reads.bind(shared);
        program.use(frame);
        quads.draw();
    }

    private void sort(ParticleArrays all, View view) {
        for (int i = 0; i < isSeen.length; i++) {
            var centre = particles.emitters().get(i).centre();
            centres[3 * i] = (float) (centre.x() - view.eyeX());
            centres[3 * i + 1] = (float) (centre.y() - view.eyeY());
            centres[3 * i + 2] = (float) (centre.z() - view.eyeZ());
        }
        float backX = (float) view.back().x();
        float backY = (float) view.back().y();
        float backZ = (float) view.back().z();
        order.begin(all.count());
        for (int i = 0; i < all.count(); i++) {
            int emitter = all.emitter(i);
            if (isSeen[emitter]) {
                float x = centres[3 * emitter] + all.x(i);
                float y = centres[3 * emitter + 1] + all.y(i);
                float z = centres[3 * emitter + 2] + all.z(i);
                if (x * backX + y * backY + z * backZ < reach(all, i)) {
                    order.add(i, x * x + y * y + z * z);
                }
            }
        }
        order.sort();
    }

    /** Returns a bound of the distance from a particle's middle to its corners. */
    private static float reach(ParticleArrays all, int i) {
        return 1.5f * all.halfWidth(i) + Math.abs(all.alongX(i)) + Math.abs(all.alongY(i)) + Math.abs(all.alongZ(i));
    }

    private void put(ParticleArrays all, int i, FloatBuffer out) {
        int emitter = all.emitter(i);
        float lit = all.albedo(i) * all.opacity(i);
        out.put(centres[3 * emitter] + all.x(i));
        out.put(centres[3 * emitter + 1] + all.y(i));
        out.put(centres[3 * emitter + 2] + all.z(i));
        out.put(all.halfWidth(i));
        out.put(all.red(i) + lit * light.radiance(emitter, 0));
        out.put(all.green(i) + lit * light.radiance(emitter, 1));
        out.put(all.blue(i) + lit * light.radiance(emitter, 2));
        out.put(all.opacity(i));
        boolean isBillow =
                all.look(i) >= ParticlePicture.BILLOW.first() && all.look(i) < ParticlePicture.TONGUE.first();
        out.put(isBillow ? light.relief(emitter, 0) : all.alongX(i));
        out.put(isBillow ? light.relief(emitter, 1) : all.alongY(i));
        out.put(isBillow ? light.relief(emitter, 2) : all.alongZ(i));
        out.put(all.look(i));
    }
}
