package nephele.lab.placement;

import java.util.List;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.placement.FourLineCheck;

/**
 * The question whether a rectangle fits at the aimed place on a wall of triangles, prepared for the student report's
 * four lines, with the true answer from clipped areas.
 *
 * @param triangle index of the triangle at the aimed place
 * @param halfRight from the centre to the rectangle's right side, {@code halfUp} to its upper one
 */
public record RectangleQuestion(
        WallShot shot,
        Aperture rectangle,
        FourLineCheck lines,
        int triangle,
        Vec3 halfRight,
        Vec3 halfUp,
        boolean fits) {
    /** Returns the question for a rectangle of the gun's width and height. */
    public static RectangleQuestion of(WallShot shot) {
        Aperture aimed = shot.gun.aperture();
        Aperture rectangle = Aperture.of(PortalShape.RECTANGLE, aimed.widthMetres(), aimed.heightMetres());
        WallPlace place = shot.wall.place();
        Vec3 up = place.expectedUp(shot.aim.view());
        Vec3 right = up.cross(place.normal());
        int triangle = 0;
        while (!ClippedAreas.contains(shot.wall.pieces().get(triangle), shot.x, shot.y)) {
            triangle++;
        }
        boolean fits = new ClippedAreas(shot.wall.pieces(), List.of())
                .isWhole(WallShot.shape(rectangle, shot, 0), shot.x, shot.y);
        return new RectangleQuestion(
                shot,
                rectangle,
                new FourLineCheck(shot.wall.soup()),
                triangle,
                right.scaled(rectangle.widthMetres() / 2),
                up.scaled(rectangle.heightMetres() / 2),
                fits);
    }

    /** Returns the answer of the four lines. */
    public boolean byFourLines() {
        return lines.fits(triangle, shot.wall.place().world(shot.x, shot.y, 0), halfRight, halfUp);
    }
}
