package nephele.engine.particle;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.Emitter;
import nephele.engine.math.Chance;

/**
 * The particles of one emitter at any time. Particle n is born at the time (n + a random number) / rate after the start,
 * so those alive are a window of indices that the time gives.
 */
final class EmitterParticles {
    /** The time within which all particles of an explosion are born. */
    private static final double BURST_SECONDS = 0.04;

    private static final int BIRTH = 40;

    private final Emitter emitter;
    private final ParticleLaw law;
    /** {@code null} if nothing falls. */
    private final ColumnHeights ends;

    private final ParticleState state = new ParticleState();

    /** @param world of which surfaces end what falls; {@code null} for none */
    EmitterParticles(Emitter emitter, CollisionWorld world) {
        this.emitter = emitter;
        law = ParticleLaw.of(emitter);
        ends = world != null && falls(emitter) ? ColumnHeights.of(emitter, world) : null;
    }

    static boolean falls(Emitter emitter) {
        return emitter.kind() == Emitter.Kind.RAIN || emitter.kind() == Emitter.Kind.SNOW;
    }

    /** Adds the particles that are alive, by index. */
    void addTo(ParticleArrays out, int number, double seconds) {
        double clock = seconds - emitter.startSeconds();
        if (clock < 0 || emitter.ratePerSecond() == 0) {
            return;
        }
        switch (emitter.kind()) {
            case EXPLOSION -> burst(out, number, clock);
            case QUADS -> places(out, number, clock);
            default -> window(out, number, clock);
        }
    }

    private void window(ParticleArrays out, int number, double clock) {
        double rate = emitter.ratePerSecond();
        double longest = emitter.longestLifeSeconds();
        long first = Math.max(0, (long) Math.ceil((clock - longest) * rate - 1));
        long last = (long) Math.floor(clock * rate);
        for (long index = first; index <= last; index++) {
            double age = clock - (index + Chance.unit(Chance.dice(emitter.seed(), index), BIRTH)) / rate;
            if (age >= 0 && age < longest && law.at(index, age, clock, state) && isAbove(state)) {
                out.add(number, state);
            }
        }
    }

    private boolean isAbove(ParticleState particle) {
        return ends == null || particle.y - particle.alongY > ends.at(particle.x, particle.z);
    }

    private void burst(ParticleArrays out, int number, double clock) {
        double repeat = emitter.repeatSeconds();
        long burst = repeat > 0 ? (long) Math.floor(clock / repeat) : 0;
        double since = clock - burst * repeat;
        long count = Math.round(emitter.ratePerSecond());
        if (since > emitter.longestLifeSeconds() + BURST_SECONDS) {
            return;
        }
        for (long i = 0; i < count; i++) {
            long index = burst * count + i;
            double age = since - BURST_SECONDS * Chance.unit(Chance.dice(emitter.seed(), index), BIRTH);
            if (age >= 0 && law.at(index, age, clock, state)) {
                out.add(number, state);
            }
        }
    }

    private void places(ParticleArrays out, int number, double clock) {
        long count = (long) emitter.mostAtOnce();
        for (long place = 0; place < count; place++) {
            if (law.at(place, 0, clock, state)) {
                out.add(number, state);
            }
        }
    }
}
