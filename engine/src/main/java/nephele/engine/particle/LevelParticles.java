package nephele.engine.particle;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.Emitter;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;

/** The particles of a level's emitters. Evaluated once for all views of a frame. */
public final class LevelParticles {
    /** What sways, spreads or is wide leaves the box by at most this fraction of its longest edge, and a metre. */
    private static final double BEYOND_BOX = 0.75;

    private final List<Emitter> emitters;
    private final List<EmitterParticles> particles = new ArrayList<>();
    private final List<Aabb> bounds = new ArrayList<>();
    private final EmitterSurroundings surroundings;
    private final ParticleArrays arrays;
    private double evaluated = Double.NaN;
    private Portals portals = Portals.NONE;

    /**
     * Prepares emitters.
     *
     * @param statics the level's, of which surfaces end rain and snow
     */
    public LevelParticles(List<Emitter> emitters, StaticShapes statics) {
        this.emitters = List.copyOf(emitters);
        CollisionWorld world = CollisionWorld.of(statics);
        surroundings = new EmitterSurroundings(world);
        double capacity = 0;
        for (Emitter emitter : emitters) {
            particles.add(new EmitterParticles(emitter, world));
            bounds.add(bounds(emitter));
            capacity += emitter.mostAtOnce();
        }
        arrays = new ParticleArrays((int) Math.min(capacity, Emitter.MOST_PARTICLES) + 1);
    }

    private static Aabb bounds(Emitter emitter) {
        Vec3 size = emitter.size();
        double longest = Math.max(size.x(), Math.max(size.y(), size.z()));
        Aabb around = Aabb.around(emitter.centre(), size).grown(BEYOND_BOX * longest + 1 + emitter.widthMetres());
        double fallen = fallenMetres(emitter);
        return fallen == 0 ? around : around.union(around.moved(new Vec3(0, -fallen, 0)));
    }

    /** Returns how far thrown particles can fall in their lives. */
    private static double fallenMetres(Emitter emitter) {
        double seconds =
                switch (emitter.kind()) {
                    case SPARKS -> emitter.longestLifeSeconds();
                    case EXPLOSION -> ExplosionLaw.PIECES_LIFE * emitter.longestLifeSeconds();
                    default -> 0;
                };
        return 0.5 * ParticleLaw.GRAVITY * seconds * seconds;
    }

    public List<Emitter> emitters() {
        return emitters;
    }

    /** Returns what the level hides from emitters. */
    public EmitterSurroundings surroundings() {
        return surroundings;
    }

    /** Takes the portals that exist from now on: rain falls into open ones. */
    public void follow(Portals now) {
        if (now == portals) {
            return;
        }
        portals = now;
        for (int i = 0; i < particles.size(); i++) {
            if (particles.get(i).follow(now)) {
                Aabb behind = particles.get(i).behindPortals();
                Aabb box = bounds(emitters.get(i));
                bounds.set(i, behind.isEmpty() ? box : box.union(behind.grown(1)));
                evaluated = Double.NaN;
            }
        }
    }

    /** Returns a box of the world that no particle of an emitter leaves. */
    public Aabb bounds(int emitter) {
        return bounds.get(emitter);
    }

    /** Returns the particles at a time, which stay valid until the next call. Order: by emitter, then by index. */
    public ParticleArrays at(double seconds) {
        if (seconds != evaluated) {
            arrays.clear();
            for (int i = 0; i < particles.size(); i++) {
                particles.get(i).addTo(arrays, i, seconds);
            }
            evaluated = seconds;
        }
        return arrays;
    }
}
