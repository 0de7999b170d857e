package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.level.Brush;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalGun;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions.Stance;

/**
 * The exits and portals of a level, those that a gun can shoot at its panels among them, and where a player can stand
 * and see them from {@value #FAR_METRES} m, or from as far as there is room.
 */
final class LevelSigns {
    private static final double FAR_METRES = 20;
    private static final double LEAST_METRES = 4;
    private static final double[] DISTANCES = {FAR_METRES, 14, 10, 7, LEAST_METRES};
    private static final int DIRECTIONS = 24;
    /** The most slanting sight of a portal, as the cosine to its normal. */
    private static final double LEAST_FACING = 0.4;

    private static final double ABOVE_METRES = 2.5;
    private static final double BELOW_METRES = 60;

    /**
     * An exit or a portal.
     *
     * @param normal of a portal; {@code null} for an exit
     * @param halfMetres half of its greatest extent
     */
    record Sign(String name, Vec3 centre, Vec3 normal, double halfMetres) {}

    private final CollisionWorld world;
    private final RayCast cast = new RayCast();
    private final List<Sign> signs = new ArrayList<>();
    private final List<Portal> shots = new ArrayList<>();
    private final Level level;

    LevelSigns(PlacedLevel placed) {
        level = placed.level();
        world = CollisionWorld.of(placed.statics());
        for (Exit exit : level.exits()) {
            Vec3 middle = exit.feet().plus(new Vec3(0, exit.heightMetres() / 2, 0));
            double half = Math.hypot(exit.radiusMetres(), exit.heightMetres() / 2);
            signs.add(new Sign("exit " + exit.id(), middle, null, half));
        }
        level.portals().forEach(spec -> add("portal " + spec.id(), Portal.of(spec)));
        if (level.portalGun() != null) {
            placed.statics().solids().forEach(this::addShot);
        }
        for (int i = 0; i < shots.size(); i++) {
            add("shot " + shots.get(i).id(), shots.get(i));
        }
    }

    private void add(String name, Portal portal) {
        double half =
                Math.hypot(portal.aperture().widthMetres(), portal.aperture().heightMetres()) / 2;
        signs.add(new Sign(name, portal.centre(), portal.normal(), half));
    }

    /** Adds a portal in the middle of a portalable wall that has room for it; at most two, one for each shot. */
    private void addShot(Brush brush) {
        PortalGun gun = level.portalGun();
        for (int i = 0; i < brush.faces().size() && shots.size() < 2; i++) {
            ConvexPolyhedron.Face face = brush.shape().faces().get(i);
            Vec3 normal = face.plane().normal();
            double height = height(face);
            if (brush.faces().get(i).portalable() && Math.abs(normal.y()) < 0.5 && height >= gun.heightMetres()) {
                Vec3 middle = Vec3.ZERO;
                for (Vec3 corner : face.polygon()) {
                    middle = middle.addScaled(1.0 / face.polygon().size(), corner);
                }
                var aperture = Aperture.of(gun.shape(), gun.widthMetres(), gun.heightMetres());
                String id = shots.size() + " of " + level.name();
                shots.add(new Portal(id, middle, Portal.facing(normal, new Vec3(0, 1, 0)), aperture));
            }
        }
    }

    private static double height(ConvexPolyhedron.Face face) {
        double low = face.polygon().stream().mapToDouble(Vec3::y).min().orElse(0);
        double high = face.polygon().stream().mapToDouble(Vec3::y).max().orElse(0);
        return high - low;
    }

    List<Sign> signs() {
        return signs;
    }

    /** Returns the level's portals and then the shots, linked to each other. */
    Portals portals() {
        Portals own = Portals.of(level);
        List<Portal> all = new ArrayList<>();
        List<Integer> partners = new ArrayList<>();
        for (int i = 0; i < own.size(); i++) {
            all.add(own.portal(i));
            partners.add(own.partner(i));
        }
        for (int i = 0; i < shots.size(); i++) {
            all.add(shots.get(i));
            partners.add(shots.size() < 2 ? Portals.CLOSED : own.size() + 1 - i);
        }
        return new Portals(all, partners);
    }

    /** Returns the number of the first shot among {@link #portals}. */
    int firstShot() {
        return level.portals().size();
    }

    /** Returns players who look at a sign, the farthest first; empty if nobody can stand where it is visible. */
    List<PlayerStart> viewers(Sign sign) {
        List<PlayerStart> found = new ArrayList<>();
        for (int i = 0; i < DIRECTIONS; i++) {
            double turn = 2 * Math.PI * i / DIRECTIONS;
            Vec3 away = new Vec3(Math.sin(turn), 0, Math.cos(turn));
            if (sign.normal() != null && away.dot(sign.normal()) < LEAST_FACING) {
                continue;
            }
            for (double metres : DISTANCES) {
                PlayerStart viewer = viewer(sign, sign.centre().addScaled(metres, away));
                if (viewer != null) {
                    found.add(viewer);
                    break;
                }
            }
        }
        found.sort(Comparator.comparingDouble(
                viewer -> -Math.rint(fromEye(viewer.feet(), sign).length())));
        return found;
    }

    private PlayerStart viewer(Sign sign, Vec3 over) {
        Vec3 from = over.plus(new Vec3(0, ABOVE_METRES, 0));
        if (!cast.cast(world, Ray.of(from, new Vec3(0, -1, 0)), BELOW_METRES)) {
            return null;
        }
        Vec3 feet = from.plus(new Vec3(0, -cast.distance() + 0.02, 0));
        Vec3 eye = eye(feet);
        Vec3 towards = fromEye(feet, sign);
        double metres = towards.length();
        boolean isFree = !cast.cast(world, Ray.of(eye, towards.scaled(1 / metres)), metres - 0.1)
                && !cast.cast(world, Ray.of(eye, new Vec3(0, 1, 0)), 0.3);
        if (!isFree || metres > 1.2 * FAR_METRES || metres < LEAST_METRES) {
            return null;
        }
        double yaw = Math.toDegrees(Math.atan2(-towards.x(), -towards.z()));
        double pitch = Math.toDegrees(Math.asin(towards.y() / metres));
        return new PlayerStart(feet, yaw, pitch);
    }

    private static Vec3 fromEye(Vec3 feet, Sign sign) {
        return sign.centre().minus(eye(feet));
    }

    private static Vec3 eye(Vec3 feet) {
        return feet.plus(new Vec3(0, Stance.STANDING.eyeMetres(), 0));
    }
}
