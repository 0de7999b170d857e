package nephele.engine.particle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Emitter;
import nephele.engine.level.RecordCopy;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The report's particles are those of its loop over frames. */
@Execution(ExecutionMode.CONCURRENT)
class QuadLawTest {
    private static final Emitter EMITTER =
            new Emitter("e", Emitter.Kind.QUADS, Vec3.ZERO, new Vec3(7.2, 7.2, 7.2), 63.2);

    /** Runs the loop as it is stated: place += speed / 250, speed *= 0.99, life −= its share, until life < 0.05. */
    @Test
    void atWholeFramesItIsTheLoop() {
        QuadLaw law = new QuadLaw(EMITTER);
        ParticleState state = new ParticleState();
        for (int place = 0; place < 100; place++) {
            law.at(place, 3, 1.0 / 60, state);
            double speed = 250 * Math.sqrt(state.x * state.x + state.y * state.y + state.z * state.z);
            assertTrue(speed >= 1 && speed <= 9, "speed " + speed);
            double life = 1;
            double way = 0;
            int frame = 0;
            while (life >= 0.05) {
                law.at(place, 3, frame / 60.0, state);
                double flown = Math.sqrt(state.x * state.x + state.y * state.y + state.z * state.z);
                assertEquals(way, flown, 1e-3);
                assertEquals(life, state.opacity, 1e-9);
                way += speed / 250;
                speed *= 0.99;
                life -= law.fall(place);
                frame++;
            }
            assertEquals(law.frames(place), frame);
            assertTrue(frame >= 64 && frame <= 191, "frames " + frame);
        }
    }

    @Test
    void thereAreAlwaysAHundredOfThem() {
        LevelParticles particles = TestEmitters.particles(List.of(RecordCopy.with(EMITTER, "startSeconds", -5)));
        for (double seconds = 0; seconds < 10; seconds += 0.173) {
            ParticleArrays at = particles.at(seconds);
            assertEquals(100, at.count());
            for (int i = 0; i < at.count(); i++) {
                assertEquals(0.2, at.get(i, ParticleArrays.HALF_WIDTH), 1e-6);
                assertEquals(ParticlePicture.CLOUD.first(), (int) at.get(i, ParticleArrays.LOOK));
                for (int channel = ParticleArrays.RED; channel < ParticleArrays.RED + 3; channel++) {
                    assertEquals(
                            at.get(i, ParticleArrays.OPACITY), at.get(i, channel), 1e-6, "white, as thick as it is");
                }
                assertTrue(at.get(i, ParticleArrays.OPACITY) >= 0.035, "opacity " + at.get(i, ParticleArrays.OPACITY));
            }
        }
    }
}
