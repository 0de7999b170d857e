package nephele.editor.paint;

import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Material;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.TextureFrame.Extent;
import nephele.engine.math.Directions;
import nephele.engine.math.Isometry;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;

/**
 * Finds the placements of pictures on faces. A placement has the smallest shift that shows the wanted picture, so
 * texture coordinates are as wanted but for whole repeats.
 */
public final class TextureFit {
    /** Sine of the angle below which two planes count as parallel. */
    private static final double PARALLEL = 1e-9;

    private TextureFit() {}

    /**
     * Returns the placement with which the picture covers the rectangle around the face exactly. A turned or mirrored
     * picture stays so; the rectangle is turned with it.
     *
     * @param repeatsU number of repeats side by side, greater than 0
     * @param repeatsV number of repeats one above the other
     */
    public static TexturePlacement fit(PaintedFace face, double repeatsU, double repeatsV) {
        PictureMapping now = PictureMapping.of(face);
        Extent u = Extent.of(face.face(), now.across());
        Extent v = Extent.of(face.face(), now.up());
        Vec3 leftTop = now.across().scaled(u.least()).addScaled(v.most(), now.up());
        return new PictureMapping(
                        leftTop,
                        new TextureCoordinates(0, 0),
                        now.across(),
                        now.up(),
                        u.metres() / repeatsU,
                        v.metres() / repeatsV)
                .placementOn(face);
    }

    /** Returns the placement of {@link #fit(PaintedFace, double, double)} for a face with a material. */
    public static TexturePlacement fit(BrushFace face, Material material, double repeatsU, double repeatsV) {
        return fit(PaintedFace.of(face, material), repeatsU, repeatsV);
    }

    /** Returns the placement with the picture moved, in one of its two directions, to an edge or the middle. */
    public static TexturePlacement align(PaintedFace face, TextureAlignment alignment) {
        PictureMapping now = PictureMapping.of(face);
        Extent u = Extent.of(face.face(), now.across());
        Extent v = Extent.of(face.face(), now.up());
        double fraction = alignment.fraction();
        double right = alignment.isHorizontal() ? u.least() + fraction * u.metres() : 0;
        double top = alignment.isHorizontal() ? 0 : v.most() - fraction * v.metres();
        Vec3 place = now.across().scaled(right).addScaled(top, now.up());
        TextureCoordinates there = now.at(place);
        return now.with(
                        place,
                        alignment.isHorizontal()
                                ? new TextureCoordinates(fraction, there.v())
                                : new TextureCoordinates(there.u(), fraction))
                .placementOn(face);
    }

    /**
     * Returns the placement that keeps the picture on a face that has moved.
     *
     * @param after the face at its new place; its own placement does not count
     */
    public static TexturePlacement locked(PaintedFace before, PaintedFace after, Isometry move) {
        return PictureMapping.of(before).moved(move).placementOn(after.with(before.placement()));
    }

    /**
     * Returns the placement with which a picture continues from one face to another, as paper folded along the line
     * where their planes meet. Faces with opposite normals have no such line: the placement is repeated.
     */
    public static TexturePlacement continued(PaintedFace from, PaintedFace to) {
        Vec3 normal = to.face().plane().normal();
        Vec3 other = from.face().plane().normal();
        Vec3 line = normal.cross(other);
        PictureMapping picture = PictureMapping.of(from);
        if (line.length() < PARALLEL) {
            return normal.dot(other) < 0 ? from.placement() : picture.placementOn(to.with(from.placement()));
        }
        double radians = -Directions.angle(normal, other);
        RigidMove fold = new RigidMove(Rotations.aroundAxis(line, radians), onBoth(from, to, line), Vec3.ZERO);
        return picture.moved(fold).placementOn(to.with(from.placement()));
    }

    /** Returns the point on both planes that is nearest to the middle of the face that is painted. */
    private static Vec3 onBoth(PaintedFace from, PaintedFace to, Vec3 line) {
        Vec3 middle = to.middle();
        Vec3 inPlane = Directions.unit(to.face().plane().normal().cross(line));
        double slope = inPlane.dot(from.face().plane().normal());
        return middle.addScaled(-from.face().plane().signedDistance(middle) / slope, inPlane);
    }

    /** Returns the point of the picture that a face shows at a point of its plane. */
    public static TextureCoordinates uvAt(PaintedFace face, Vec3 point) {
        return PictureMapping.of(face).at(point);
    }

    /**
     * A place in a repeated picture, in repeats.
     *
     * @param u to the picture's right, 0 at its left edge
     * @param v downwards, 0 at its top edge
     */
    public record TextureCoordinates(double u, double v) {}
}
