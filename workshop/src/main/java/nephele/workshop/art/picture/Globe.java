package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Pixels;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Paints equirectangular pictures for spheres: longitude to the right, latitude upwards. */
final class Globe {
    private Globe() {}

    /** Returns the colour in a direction from the centre; y is north. */
    interface Brush {
        PaintColour at(Vector3dc direction);
    }

    /** Paints a picture that is twice as wide as high. */
    static BufferedImage paint(int height, Brush brush) {
        int width = 2 * height;
        Vector3d direction = new Vector3d();
        return Pixels.picture(width, height, (column, row) -> {
            double latitude = Math.PI * (0.5 - (row + 0.5) / height);
            double longitude = 2 * Math.PI * (column + 0.5) / width;
            return brush.at(towards(longitude, latitude, direction)).rgb();
        });
    }

    /** Returns the unit vector of a longitude and a latitude. */
    static Vector3d direction(double longitudeDegrees, double latitudeDegrees) {
        double longitude = StrictMath.toRadians(longitudeDegrees);
        return towards(longitude, StrictMath.toRadians(latitudeDegrees), new Vector3d());
    }

    private static Vector3d towards(double longitude, double latitude, Vector3d direction) {
        double ring = StrictMath.cos(latitude);
        return direction.set(
                ring * StrictMath.sin(longitude), StrictMath.sin(latitude), ring * StrictMath.cos(longitude));
    }
}
