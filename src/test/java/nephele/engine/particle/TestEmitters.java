package nephele.engine.particle;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.level.Emitter;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;

/** Emitters for tests, and their particles as plain numbers. */
final class TestEmitters {
    private TestEmitters() {}

    static Emitter of(Emitter.Kind kind, double ratePerSecond) {
        double repeat = kind == Emitter.Kind.EXPLOSION ? 6 : 0;
        return new Emitter(kind.name(), kind, new Vec3(3, 2, -5), new Vec3(2, 3, 1.5), ratePerSecond, 7, 0, repeat, 0);
    }

    static List<Emitter> all() {
        List<Emitter> all = new ArrayList<>();
        for (Emitter.Kind kind : Emitter.Kind.values()) {
            all.add(of(kind, 60));
        }
        return all;
    }

    static LevelParticles particles(List<Emitter> emitters) {
        return new LevelParticles(emitters, StaticShapes.of(List.of()));
    }

    /** Returns all numbers of the particles at a time, {@link ParticleArrays#STRIDE} for each. */
    static float[] numbers(LevelParticles particles, double seconds) {
        ParticleArrays at = particles.at(seconds);
        return Arrays.copyOf(at.numbers(), ParticleArrays.STRIDE * at.count());
    }
}
