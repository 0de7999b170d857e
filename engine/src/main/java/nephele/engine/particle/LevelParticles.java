package nephele.engine.particle;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.level.Emitter;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;

/** The particles of a level's emitters. Evaluated once for all views of a frame. */
public final class LevelParticles {
    /** What sways, spreads or is wide leaves the box by at most this fraction of its longest edge, and a metre. */
    private static final double BEYOND_BOX = 0.75;

    private static final int SKY_RAYS = 64;
    private static final double FARTHEST_METRES = 1e4;
    private static final double GOLDEN_TURNS = 0.6180339887498949;

    private final List<Emitter> emitters;
    private final List<EmitterParticles> particles = new ArrayList<>();
    private final List<Aabb> bounds = new ArrayList<>();
    private final CollisionWorld world;
    private final RayCast cast = new RayCast();
    private final Ray ray = Ray.reusable();
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
        world = CollisionWorld.of(statics);
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

    /** Returns the fraction of the upper hemisphere in which no static surface hides the sky from the middle of an emitter. */
    public double skyFraction(int emitter) {
        int open = 0;
        for (int i = 0; i < SKY_RAYS; i++) {
            double y = (i + 0.5) / SKY_RAYS;
            double level = Math.sqrt(1 - y * y);
            double turns = i * GOLDEN_TURNS;
            open += isOpen(emitters.get(emitter).centre(), level * Waves.cosine(turns), y, level * Waves.sine(turns))
                    ? 1
                    : 0;
        }
        return (double) open / SKY_RAYS;
    }

    /** Returns true if no static surface is in a direction from the middle of an emitter. */
    public boolean sees(int emitter, Vec3 unitDirection) {
        return isOpen(emitters.get(emitter).centre(), unitDirection.x(), unitDirection.y(), unitDirection.z());
    }

    private boolean isOpen(Vec3 from, double x, double y, double z) {
        ray.aim(from.x(), from.y(), from.z(), x, y, z);
        return !cast.cast(world, ray, FARTHEST_METRES);
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
