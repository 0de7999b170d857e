package nephele.engine.level.appearance;

import java.util.Arrays;
import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.engine.level.Sky;
import org.joml.Vector3d;

/**
 * Six pictures around a point in the order +x −x +y −y +z −z, each as seen from the centre: sides with world up
 * upwards, +y with its bottom edge and −y with its top edge at −z.
 */
final class SkyboxFaces {
    private final SkyboxPictures faces;
    private final double[] linear;

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

    private SkyboxFaces(SkyboxPictures faces, double[] linear) {
        this.faces = faces;
        this.linear = linear;
    }

    static SkyboxFaces of(Sky.Skybox sky, Function<String, Picture> pictureOf, ColourDecoding decoding) {
        double[] linear = Arrays.stream(decoding.table())
                .map(value -> sky.whiteRadiance() * value)
                .toArray();
        return new SkyboxFaces(SkyboxPictures.of(sky, pictureOf), linear);
    }

    /** Returns the linear radiance interpolated between the four nearest pixels, also across the cube's edges. */
    Vector3d radiance(double x, double y, double z) {
        Place at = Place.of(x, y, z);
        int side = faces.side();
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

    /** A pixel beyond one edge is the adjacent face's; beyond a corner there is none, and the three around it count. */
    private void addPixel(Vector3d sum, int face, int column, int row, double weight) {
        int onColumn = clamped(column);
        int onRow = clamped(row);
        if (column != onColumn && row != onRow) {
            addPixel(sum, face, onColumn, onRow, weight / 3);
            addPixel(sum, face, column, onRow, weight / 3);
            addPixel(sum, face, onColumn, row, weight / 3);
            return;
        }
        int side = faces.side();
        Place middle = new Place(face, (2.0 * column + 1) / side - 1, 1 - (2.0 * row + 1) / side);
        Place place = column == onColumn && row == onRow ? middle : middle.folded();
        Picture picture = faces.pictures().get(place.face());
        int x = index(place.right());
        int y = index(-place.up());
        sum.add(
                weight * linear[picture.sample(x, y, 0)],
                weight * linear[picture.sample(x, y, 1)],
                weight * linear[picture.sample(x, y, 2)]);
    }

    private int index(double s) {
        return clamped((int) ((s + 1) / 2 * faces.side()));
    }

    private int clamped(int pixel) {
        return Math.min(Math.max(pixel, 0), faces.side() - 1);
    }
}
