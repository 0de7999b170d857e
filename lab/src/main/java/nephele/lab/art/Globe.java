package nephele.lab.art;

import java.awt.image.BufferedImage;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Pictures that a sphere wears: longitude to the right, latitude upwards. */
final class Globe {
    private Globe() {}

    /** The colour in a direction from the centre; y is north. */
    interface Brush {
        Colour at(Vector3dc direction);
    }

    /** Twice as wide as high. */
    static BufferedImage paint(int height, Brush brush) {
        int width = 2 * height;
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Vector3d direction = new Vector3d();
        for (int row = 0; row < height; row++) {
            double latitude = Math.PI * (0.5 - (row + 0.5) / height);
            double y = StrictMath.sin(latitude);
            double ring = StrictMath.cos(latitude);
            for (int column = 0; column < width; column++) {
                double longitude = 2 * Math.PI * (column + 0.5) / width;
                direction.set(ring * StrictMath.sin(longitude), y, ring * StrictMath.cos(longitude));
                picture.setRGB(column, row, brush.at(direction).rgb());
            }
        }
        return picture;
    }

    /** From longitude and latitude in degrees. */
    static Vector3d direction(double longitudeDegrees, double latitudeDegrees) {
        double longitude = StrictMath.toRadians(longitudeDegrees);
        double latitude = StrictMath.toRadians(latitudeDegrees);
        double ring = StrictMath.cos(latitude);
        return new Vector3d(
                ring * StrictMath.sin(longitude), StrictMath.sin(latitude), ring * StrictMath.cos(longitude));
    }
}
