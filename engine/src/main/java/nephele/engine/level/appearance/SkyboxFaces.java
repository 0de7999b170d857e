package nephele.engine.level.appearance;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import org.joml.Vector3d;

/**
 * Six pictures around a point in the order +x −x +y −y +z −z, each as seen from the centre: sides with world up
 * upwards, +y with its bottom edge and −y with its top edge at −z. A cross has −x −z +x +z in the middle row of four
 * columns and three rows, +y above −z, −y below it.
 */
final class SkyboxFaces {
    private static final int[][] CROSS_CELLS = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {3, 1}, {1, 1}};

    private final List<Face> faces;
    private final double[] linear;

    /** A square part of an 8-bit picture, in pixels. */
    private record Face(Picture picture, int left, int top, int side) {}

    /** A point of the cube: a face, and coordinates on it, −1 to 1. */
    private record Place(int face, double right, double up) {
        static Place of(double x, double y, double z) {
            double ax = Math.abs(x);
            double ay = Math.abs(y);
            double az = Math.abs(z);
            if (ax >= ay && ax >= az) {
                return x > 0 ? new Place(0, z / ax, y / ax) : new Place(1, -z / ax, y / ax);
            }
            if (ay >= az) {
                return y > 0 ? new Place(2, x / ay, z / ay) : new Place(3, x / ay, -z / ay);
            }
            return z > 0 ? new Place(4, -x / az, y / az) : new Place(5, x / az, y / az);
        }

        /** Returns the same point on the face that contains it: one step beyond an edge is on the adjacent face. */
        Place folded() {
            return switch (face) {
                case 0 -> of(1, up, right);
                case 1 -> of(-1, up, -right);
                case 2 -> of(right, 1, up);
                case 3 -> of(right, -1, -up);
                case 4 -> of(-right, up, 1);
                default -> of(right, up, -1);
            };
        }
    }

    private SkyboxFaces(List<Face> faces, ColourDecoding decoding) {
        this.faces = faces;
        linear = decoding.table();
    }

    static SkyboxFaces of(Sky.Skybox sky, Function<String, Picture> pictureOf, ColourDecoding decoding) {
        int wanted = sky.layout() == SkyboxLayout.FACES ? CROSS_CELLS.length : 1;
        if (sky.files().size() != wanted) {
            throw new IllegalArgumentException("a skybox of this layout has " + wanted + " files, not "
                    + sky.files().size());
        }
        if (sky.layout() == SkyboxLayout.FACES) {
            List<Face> faces = new ArrayList<>();
            for (String file : sky.files()) {
                Picture picture = pictureOf.apply(file).toRgba8();
                int side = faces.isEmpty() ? picture.width() : faces.get(0).side();
                SkyboxSizes.requireFace(file, picture.width(), picture.height(), side);
                faces.add(new Face(picture, 0, 0, side));
            }
            return new SkyboxFaces(faces, decoding);
        }
        String file = sky.files().get(0);
        Picture cross = pictureOf.apply(file).toRgba8();
        int side = SkyboxSizes.crossSide(file, cross.width(), cross.height());
        List<Face> faces = List.of(CROSS_CELLS).stream()
                .map(cell -> new Face(cross, cell[0] * side, cell[1] * side, side))
                .toList();
        return new SkyboxFaces(faces, decoding);
    }

    /** Returns the linear radiance interpolated between the four nearest pixels, also across the cube's edges. */
    Vector3d radiance(double x, double y, double z) {
        Place at = Place.of(x, y, z);
        int side = faces.get(at.face()).side();
        double column = (at.right() + 1) / 2 * side - 0.5;
        double row = (1 - at.up()) / 2 * side - 0.5;
        int left = (int) Math.floor(column);
        int top = (int) Math.floor(row);
        double fx = column - left;
        double fy = row - top;
        Vector3d sum = new Vector3d();
        addPixel(sum, at.face(), left, top, (1 - fx) * (1 - fy));
        addPixel(sum, at.face(), left + 1, top, fx * (1 - fy));
        addPixel(sum, at.face(), left, top + 1, (1 - fx) * fy);
        addPixel(sum, at.face(), left + 1, top + 1, fx * fy);
        return sum;
    }

    private void addPixel(Vector3d sum, int face, int column, int row, double weight) {
        int side = faces.get(face).side();
        boolean isOn = column >= 0 && column < side && row >= 0 && row < side;
        Place middle = new Place(face, (2.0 * column + 1) / side - 1, 1 - (2.0 * row + 1) / side);
        Place place = isOn ? middle : middle.folded();
        Face on = faces.get(place.face());
        Picture picture = on.picture();
        int x = on.left() + index(place.right(), on.side());
        int y = on.top() + index(-place.up(), on.side());
        sum.add(
                weight * linear[picture.sample(x, y, 0)],
                weight * linear[picture.sample(x, y, 1)],
                weight * linear[picture.sample(x, y, 2)]);
    }

    private static int index(double s, int size) {
        return Math.min(Math.max((int) ((s + 1) / 2 * size), 0), size - 1);
    }
}
