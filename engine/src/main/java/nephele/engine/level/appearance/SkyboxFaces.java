package nephele.engine.level.appearance;

import java.util.List;
import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import org.joml.Vector3d;

/**
 * Six pictures around a point in the order +x −x +y −y +z −z, each as an eye in the middle sees it: sides with world up
 * upwards, +y with its bottom edge and −y with its top edge at −z. In a cross they lie −x −z +x +z in the middle row of
 * four columns and three rows, +y above −z, −y below it.
 */
record SkyboxFaces(List<Face> faces) {
    private static final int[][] CROSS_CELLS = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {3, 1}, {1, 1}};

    /** A square part of a picture, in pixels. */
    private record Face(Picture picture, int left, int top, int side) {}

    static SkyboxFaces of(Sky.Skybox sky, Function<String, Picture> pictureOf) {
        if (sky.layout() == SkyboxLayout.FACES) {
            return new SkyboxFaces(
                    sky.files().stream().map(pictureOf).map(SkyboxFaces::whole).toList());
        }
        Picture cross = pictureOf.apply(sky.files().get(0));
        int side = Math.max(cross.width() / 4, 1);
        return new SkyboxFaces(List.of(CROSS_CELLS).stream()
                .map(cell -> new Face(cross, cell[0] * side, cell[1] * side, side))
                .toList());
    }

    private static Face whole(Picture picture) {
        return new Face(picture, 0, 0, Math.min(picture.width(), picture.height()));
    }

    /** Linear radiance of the nearest pixel. */
    Vector3d radiance(double x, double y, double z) {
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        double az = Math.abs(z);
        if (ax >= ay && ax >= az) {
            return x > 0 ? pixel(faces.get(0), z / ax, y / ax) : pixel(faces.get(1), -z / ax, y / ax);
        }
        if (ay >= az) {
            return y > 0 ? pixel(faces.get(2), x / ay, z / ay) : pixel(faces.get(3), x / ay, -z / ay);
        }
        return z > 0 ? pixel(faces.get(4), -x / az, y / az) : pixel(faces.get(5), x / az, y / az);
    }

    /**
     * A cross of wrong proportions reads its border; the sky pass refuses it by name.
     *
     * @param right and {@code up} on the face, −1 to 1
     */
    private static Vector3d pixel(Face face, double right, double up) {
        Picture picture = face.picture();
        int column = Math.min(face.left() + index(right, face.side()), picture.width() - 1);
        int row = Math.min(face.top() + index(-up, face.side()), picture.height() - 1);
        int green = picture.channels() < 3 ? 0 : 1;
        return new Vector3d(
                linear(picture, column, row, 0),
                linear(picture, column, row, green),
                linear(picture, column, row, 2 * green));
    }

    private static int index(double s, int size) {
        return Math.min(Math.max((int) ((s + 1) / 2 * size), 0), size - 1);
    }

    /** sRGB decoding (IEC 61966-2-1). */
    private static double linear(Picture picture, int column, int row, int channel) {
        double c = picture.sample(column, row, channel) / (picture.bitsPerChannel() == 8 ? 255.0 : 65535.0);
        return c <= 0.04045 ? c / 12.92 : StrictMath.pow((c + 0.055) / 1.055, 2.4);
    }
}
