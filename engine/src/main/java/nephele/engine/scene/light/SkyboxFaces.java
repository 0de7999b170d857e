package nephele.engine.scene.light;

import nephele.engine.asset.Picture;
import org.joml.Vector3d;

/** Six pictures around a point, as OpenGL's cube maps lie (OpenGL 4.1 specification, table 3.19). */
final class SkyboxFaces {
    private SkyboxFaces() {}

    /** Linear radiance of the nearest pixel. */
    static Vector3d radiance(Picture[] faces, double x, double y, double z) {
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        double az = Math.abs(z);
        if (ax >= ay && ax >= az) {
            return x > 0 ? pixel(faces[0], -z / ax, -y / ax) : pixel(faces[1], z / ax, -y / ax);
        }
        if (ay >= az) {
            return y > 0 ? pixel(faces[2], x / ay, z / ay) : pixel(faces[3], x / ay, -z / ay);
        }
        return z > 0 ? pixel(faces[4], x / az, -y / az) : pixel(faces[5], -x / az, -y / az);
    }

    private static Vector3d pixel(Picture face, double s, double t) {
        int column = index(s, face.width());
        int row = index(t, face.height());
        int green = face.channels() < 3 ? 0 : 1;
        return new Vector3d(
                linear(face, column, row, 0), linear(face, column, row, green), linear(face, column, row, 2 * green));
    }

    private static int index(double s, int size) {
        return Math.min(Math.max((int) ((s + 1) / 2 * size), 0), size - 1);
    }

    /** sRGB decoding (IEC 61966-2-1). */
    private static double linear(Picture face, int column, int row, int channel) {
        double c = face.sample(column, row, channel) / (face.bitsPerChannel() == 8 ? 255.0 : 65535.0);
        return c <= 0.04045 ? c / 12.92 : StrictMath.pow((c + 0.055) / 1.055, 2.4);
    }
}
