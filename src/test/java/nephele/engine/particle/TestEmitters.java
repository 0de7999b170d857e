package nephele.engine.particle;

import java.util.ArrayList;
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

    /** Returns all numbers of the particles at a time, 14 for each. */
    static float[] numbers(LevelParticles particles, double seconds) {
        ParticleArrays at = particles.at(seconds);
        float[] numbers = new float[14 * at.count()];
        for (int i = 0; i < at.count(); i++) {
            float[] one = {
                at.x(i), at.y(i), at.z(i), at.halfWidth(i), at.alongX(i), at.alongY(i), at.alongZ(i),
                at.opacity(i), at.albedo(i), at.red(i), at.green(i), at.blue(i), at.look(i), at.emitter(i)
            };
            System.arraycopy(one, 0, numbers, 14 * i, 14);
        }
        return numbers;
    }
}
