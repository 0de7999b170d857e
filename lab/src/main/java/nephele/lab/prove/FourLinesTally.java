package nephele.lab.prove;

import java.util.List;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.placement.FourLines;

/** How often the four lines of the student report answer otherwise than the areas, for its rectangle where one aims. */
final class FourLinesTally {
    private int asked;
    private int accepted;
    private int wronglyAccepted;
    private int wronglyRefused;

    void judge(WallShot shot) {
        if (shot.wall.soup() == null) {
            return;
        }
        Aperture rectangle = Aperture.of(
                PortalShape.RECTANGLE,
                shot.gun.aperture().widthMetres(),
                shot.gun.aperture().heightMetres());
        Vec3 up = shot.wall.place().expectedUp(shot.aim.view());
        Vec3 right = Directions.cross(up, shot.wall.place().normal());
        boolean fits = new FourLines(shot.wall.soup())
                .fits(
                        triangle(shot),
                        shot.wall.place().world(shot.x, shot.y, 0),
                        scaled(right, rectangle.widthMetres() / 2),
                        scaled(up, rectangle.heightMetres() / 2));
        boolean whole = new ClippedAreas(shot.wall.pieces(), List.of())
                .isWhole(WallShot.shape(rectangle, shot, 0), shot.x, shot.y);
        asked++;
        accepted += fits ? 1 : 0;
        wronglyAccepted += fits && !whole ? 1 : 0;
        wronglyRefused += whole && !fits ? 1 : 0;
    }

    private static int triangle(WallShot shot) {
        int triangle = 0;
        while (!ClippedAreas.contains(shot.wall.pieces().get(triangle), shot.x, shot.y)) {
            triangle++;
        }
        return triangle;
    }

    private static Vec3 scaled(Vec3 v, double by) {
        return new Vec3(v.x() * by, v.y() * by, v.z() * by);
    }

    List<Figure> figures() {
        return List.of(
                Figure.sum("rectangles shown to the four lines", asked, ""),
                Figure.sum("accepted by them", accepted, ""),
                Figure.sum("wrongly accepted", wronglyAccepted, ""),
                Figure.sum("wrongly refused", wronglyRefused, ""));
    }
}
