package nephele.editor.paint;

import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.level.appearance.TextureFrame;
import nephele.engine.math.Isometry;
import nephele.engine.math.Vec3;

/**
 * A picture in a plane of the world, apart from the way in which a face says it.
 *
 * @param at a point of the plane, near the face so that rounding is small
 * @param atPoint the picture's place at that point
 * @param across unit direction in which u grows
 * @param up unit direction in which v falls, perpendicular
 * @param uMetres width of one repeat
 * @param vMetres its height
 */
record PictureMapping(
        Vec3 at, TextureFit.TextureCoordinates atPoint, Vec3 across, Vec3 up, double uMetres, double vMetres) {
    /** Decimal places of degrees and metres that are kept, so that a level's text stays short. */
    private static final double DEGREE_STEPS = 1e10;

    private static final double METRE_STEPS = 1e12;

    static PictureMapping of(PaintedFace painted) {
        FaceTexture texture = painted.texture();
        Vec3 at = painted.middle();
        return new PictureMapping(
                at,
                new TextureFit.TextureCoordinates(texture.s(at), texture.t(at)),
                texture.across(),
                texture.up(),
                texture.sMetres(),
                texture.tMetres());
    }

    TextureFit.TextureCoordinates at(Vec3 point) {
        Vec3 off = point.minus(at);
        return new TextureFit.TextureCoordinates(
                atPoint.u() + off.dot(across) / uMetres, atPoint.v() - off.dot(up) / vMetres);
    }

    /** Returns the same picture with another place at a point. */
    PictureMapping with(Vec3 point, TextureFit.TextureCoordinates there) {
        return new PictureMapping(point, there, across, up, uMetres, vMetres);
    }

    /** Returns the picture after a move of everything. */
    PictureMapping moved(Isometry move) {
        return new PictureMapping(
                move.point(at), atPoint, move.direction(across), move.direction(up), uMetres, vMetres);
    }

    /**
     * Returns the placement by which a face shows this picture, with the smallest shift: the coordinates differ from
     * this mapping's by whole repeats.
     */
    TexturePlacement placementOn(PaintedFace painted) {
        TextureFrame frame = painted.frame();
        boolean isMirrored = painted.placement().scaleU() < 0;
        Vec3 right = isMirrored ? across.negated() : across;
        double degrees = rounded(
                Math.toDegrees(StrictMath.atan2(right.dot(frame.up()), right.dot(frame.across()))), DEGREE_STEPS);
        double sign = up.dot(frame.turnedUp(degrees)) < 0 ? -1 : 1;
        double scaleU = shortened((isMirrored ? -1 : 1) * uMetres / frame.uMetres());
        double scaleV = shortened(sign * vMetres / frame.vMetres());
        Vec3 shift = shift(painted, new TexturePlacement(0, 0, degrees, scaleU, scaleV));
        return new TexturePlacement(
                rounded(shift.dot(frame.across()), METRE_STEPS),
                rounded(shift.dot(frame.up()), METRE_STEPS),
                degrees,
                scaleU,
                scaleV);
    }

    /** Returns the shift that a placement without one needs, measured at the middle of the face. */
    private Vec3 shift(PaintedFace painted, TexturePlacement unshifted) {
        FaceTexture placed = painted.with(unshifted).texture();
        Vec3 middle = painted.middle();
        TextureFit.TextureCoordinates wanted = at(middle);
        double u = placed.s(middle) - wanted.u();
        double v = placed.t(middle) - wanted.v();
        return placed.across()
                .scaled((u - Math.rint(u)) * placed.sMetres())
                .addScaled(-(v - Math.rint(v)) * placed.tMetres(), placed.up());
    }

    /** Adding 0 makes a negative zero positive. */
    private static double rounded(double value, double steps) {
        return Math.rint(value * steps) / steps + 0.0;
    }

    /** Returns the value with the 13 digits that survive arithmetic. */
    private static double shortened(double value) {
        double steps = StrictMath.pow(10, 12 - Math.floor(StrictMath.log10(Math.abs(value))));
        return Math.rint(value * steps) / steps;
    }
}
