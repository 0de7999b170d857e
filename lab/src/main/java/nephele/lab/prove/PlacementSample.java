package nephele.lab.prove;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.placement.FourLines;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.MovingSurfaces;
import nephele.engine.portal.placement.Placed;
import nephele.engine.portal.placement.Placement;

/**
 * Rectangles shot at walls of triangles with holes, as the placement proof makes them, each prepared for both ways of
 * asking whether it fits where one aims, and with the true answer from clipped areas. Nothing stands on these walls: the four
 * lines know of nothing but triangles.
 */
public final class PlacementSample {
    private final List<Question> questions = new ArrayList<>();

    private record Question(
            WallShot shot, int triangle, Vec3 right, Vec3 up, FourLines fourLines, Placement fixed, boolean fits) {}

    public PlacementSample(int count) {
        for (long seed = 0; questions.size() < count; seed++) {
            var random = new SplittableRandom(seed);
            WallShot shot = new WallShot(RandomWall.of(random), random);
            if (shot.wall.soup() != null && shot.wall.columns().isEmpty()) {
                questions.add(question(shot));
            }
        }
    }

    private static Question question(WallShot shot) {
        Aperture rectangle = Aperture.of(
                PortalShape.RECTANGLE,
                shot.gun.aperture().widthMetres(),
                shot.gun.aperture().heightMetres());
        Vec3 up = shot.wall.place().expectedUp(shot.aim.view());
        Vec3 right = Directions.cross(up, shot.wall.place().normal());
        int triangle = 0;
        while (!ClippedAreas.contains(shot.wall.pieces().get(triangle), shot.x, shot.y)) {
            triangle++;
        }
        return new Question(
                shot,
                triangle,
                scaled(right, rectangle.widthMetres() / 2),
                scaled(up, rectangle.heightMetres() / 2),
                new FourLines(shot.wall.soup()),
                new Placement(shot.wall.surfaces(), new Gun(rectangle, shot.gun.rangeMetres(), 0)),
                new ClippedAreas(shot.wall.pieces(), List.of())
                        .isWhole(WallShot.shape(rectangle, shot, 0), shot.x, shot.y));
    }

    private static Vec3 scaled(Vec3 v, double by) {
        return new Vec3(v.x() * by, v.y() * by, v.z() * by);
    }

    public int size() {
        return questions.size();
    }

    /** Whether the rectangle fits where one aims, in truth. */
    public boolean fits(int question) {
        return questions.get(question).fits;
    }

    public boolean fourLines(int question) {
        Question asked = questions.get(question);
        Vec3 centre = asked.shot.wall.place().world(asked.shot.x, asked.shot.y, 0);
        return asked.fourLines.fits(asked.triangle, centre, asked.right, asked.up);
    }

    /** The exact answer about the very place. */
    public boolean exact(int question) {
        Question asked = questions.get(question);
        return asked.fixed.place("shot", asked.shot.aim, List.of(), MovingSurfaces.NONE) instanceof Placed.Fits;
    }
}
