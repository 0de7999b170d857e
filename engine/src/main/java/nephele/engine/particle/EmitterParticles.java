package nephele.engine.particle;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.Emitter;
import nephele.engine.math.Aabb;
import nephele.engine.math.Chance;
import nephele.engine.portal.Portals;

/**
 * The particles of one emitter at any time. Particle n is born at the time (n + a random number) / rate after the start,
 * so those alive are a window of indices that the time gives.
 */
final class EmitterParticles {
    /** The time within which all particles of an explosion are born. */
    private static final double BURST_SECONDS = 0.04;

    /**
     * The emitter's clock begins anew after this time, which no game lasts: the numbers of its particles stay whole in
     * double precision, and a window of them ends, whatever the time and the rate.
     */
    static final double CLOCK_SECONDS = 0x1p32;

    private static final int BIRTH = 40;

    private final Emitter emitter;
    private final ParticleLaw law;
    /** {@code null} if nothing falls. */
    private final ColumnHeights ends;
    /** {@code null} unless it rains. */
    private final Rainfall rain;

    private final ParticleState state = new ParticleState();

    /** @param world of which surfaces end what falls; {@code null} for none */
    EmitterParticles(Emitter emitter, CollisionWorld world) {
        this.emitter = emitter;
        law = ParticleLaw.of(emitter);
        ends = world != null && falls(emitter) ? ColumnHeights.of(emitter, world) : null;
        rain = ends != null && emitter.kind() == Emitter.Kind.RAIN ? new Rainfall(emitter, world, ends) : null;
    }

    /** Takes the portals of a frame; returns true if particles may be elsewhere because of them. */
    boolean follow(Portals portals) {
        return rain != null && rain.follow(portals);
    }

    /** Returns a box around where portals lead particles; empty for nowhere. */
    Aabb behindPortals() {
        return rain == null ? Aabb.EMPTY : rain.bounds();
    }

    static boolean falls(Emitter emitter) {
        return emitter.kind() == Emitter.Kind.RAIN || emitter.kind() == Emitter.Kind.SNOW;
    }

    /** Adds the particles that are alive, by index. */
    void addTo(ParticleArrays out, int number, double seconds) {
        double clock = (seconds - emitter.startSeconds()) % CLOCK_SECONDS;
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
        double longest = emitter.longestLifeSeconds() + (rain == null ? 0 : rain.mostSecondsBeyond());
        long first = Math.max(0, (long) Math.ceil((clock - longest) * rate - 1));
        long last = (long) Math.floor(clock * rate);
        for (long index = first; index <= last; index++) {
            double age = clock - birthSeconds(index);
            if (age >= 0 && age < longest && isVisible(index, age, clock)) {
                out.add(number, state);
            }
        }
    }

    /** Returns the time after the start at which a particle that is not part of an explosion is born. */
    double birthSeconds(long index) {
        return (index + Chance.unit(Chance.dice(emitter.seed(), index), BIRTH)) / emitter.ratePerSecond();
    }

    private boolean isVisible(long index, double age, double clock) {
        boolean inBox = law.at(index, age, clock, state);
        if (rain == null) {
            return inBox && isAbove(state);
        }
        if (!inBox) {
            FallLaw.column(emitter, index, state);
        }
        return rain.at(index, age, inBox, state);
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
