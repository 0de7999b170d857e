package nephele.lab.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.ShotRay;

/** A shot at a point of a random wall, beside up to two other portals. */
public final class WallShot {
    private static final double RANGE_METRES = 100;

    public final RandomWall wall;
    /** The gun, whose aperture is random. */
    public final Gun gun;
    /** The aimed point in the wall's frame, metres. */
    public final double x;

    public final double y;
    /** The eye and its view of the aimed point. */
    public final ShotRay aim;
    /** The pieces that the portal may slide to from the aimed point. */
    public final List<double[]> pieces;

    /** The portals that are on the wall already. */
    public final List<Portal> others = new ArrayList<>();

    /** Creates a shot at any point of the wall's pieces. */
    public WallShot(RandomWall wall, SplittableRandom random) {
        this.wall = wall;
        Aperture aperture = random.nextInt(3) == 0
                ? Aperture.of(PortalShape.ARCH, 1.2, 2.1)
                : Aperture.of(shape(random), random.nextDouble(0.4, 1.6), random.nextDouble(0.6, 2.4));
        gun = new Gun(aperture, RANGE_METRES, 0.75 / 2.1 * aperture.heightMetres());
        double[] piece = wall.pieces().get(random.nextInt(wall.pieces().size()));
        double u = random.nextDouble();
        double v = random.nextDouble(1 - u);
        x = piece[0] + u * (piece[2] - piece[0]) + v * (piece[4] - piece[0]);
        y = piece[1] + u * (piece[3] - piece[1]) + v * (piece[5] - piece[1]);
        pieces = wall.connected(x, y);
        aim = aim(random);
        for (int i = random.nextInt(5); i > 2; i--) {
            others.add(other(random));
        }
    }

    private static PortalShape shape(SplittableRandom random) {
        return PortalShape.values()[random.nextInt(3)];
    }

    /** Returns an oblique aim if nothing stands on the wall, else a perpendicular one. */
    private ShotRay aim(SplittableRandom random) {
        double away = random.nextDouble(1.5, 20);
        double slant = wall.columns().isEmpty() ? away * 1.5 : 0;
        double dx = slant * random.nextDouble(-1, 1);
        double dy = slant * random.nextDouble(-1, 1);
        Vec3 eye = wall.place().world(x + dx, y + dy, away);
        Vec3 target = wall.place().world(x, y, 0);
        Vec3 n = wall.place().normal();
        Vec3 direction = slant == 0 ? n.negated() : target.minus(eye);
        Vec3 unit = Directions.unit(direction);
        return new ShotRay(eye, WallPlace.looking(unit, random.nextDouble(-3, 3)));
    }

    private Portal other(SplittableRandom random) {
        double angle = random.nextDouble(-3, 3);
        Vec3 a = wall.place().right();
        Vec3 b = wall.place().up();
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        Vec3 right = Directions.unit(Directions.combined(a, cos, b, sin));
        Vec3 up = wall.place().normal().cross(right);
        Vec3 centre = wall.place().world(x + random.nextDouble(-2, 2), y + random.nextDouble(-2, 2), 0);
        Aperture aperture = Aperture.of(shape(random), random.nextDouble(0.4, 1.6), random.nextDouble(0.6, 2.4));
        return new Portal("other", centre, new Basis(right, up, wall.place().normal()), aperture);
    }

    /** Returns where the game places the portal. */
    public PlacementResult placed(Gun with, List<Portal> beside) {
        return new Placement(wall.surfaces(), with).place("shot", aim, beside, Obstacles.NONE);
    }

    /** Returns the obstacles on the surface: the columns and the given portals. */
    public List<double[]> inTheWay(List<Portal> beside) {
        List<double[]> all = new ArrayList<>(wall.columns());
        for (Portal portal : beside) {
            Aperture aperture = portal.aperture();
            double[] corners = new double[2 * aperture.corners()];
            for (int i = 0; i < aperture.corners(); i++) {
                Vec3 p = portal.world(aperture.cornerX(i), aperture.cornerY(i), 0);
                corners[2 * i] = wall.place().x(p);
                corners[2 * i + 1] = wall.place().y(p);
            }
            all.add(corners);
        }
        return all;
    }

    /**
     * Returns the aperture around its centre in the wall's frame, in its expected orientation, with every edge moved
     * outwards by {@code grownMetres}.
     */
    public double[] shape(double grownMetres) {
        return shape(gun.aperture(), this, grownMetres);
    }

    static double[] shape(Aperture a, WallShot shot, double grownMetres) {
        WallPlace place = shot.wall.place();
        Vec3 up = place.expectedUp(shot.aim.view());
        double upX = up.dot(place.right());
        double upY = up.dot(place.up());
        double reach = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < a.corners(); i++) {
            reach = Math.max(reach, a.edgeDistance(i));
            least = Math.min(least, a.edgeDistance(i));
        }
        // The shape is scaled such that no edge moves farther inwards, or less far outwards, than asked.
        double scale = 1 + grownMetres / (grownMetres < 0 ? reach : least);
        double[] corners = new double[2 * a.corners()];
        for (int i = 0; i < a.corners(); i++) {
            corners[2 * i] = scale * (a.cornerX(i) * upY + a.cornerY(i) * upX);
            corners[2 * i + 1] = scale * (a.cornerY(i) * upY - a.cornerX(i) * upX);
        }
        return corners;
    }
}
