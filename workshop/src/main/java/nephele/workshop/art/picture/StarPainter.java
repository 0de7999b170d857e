package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import nephele.engine.math.SeededNoise;
import nephele.workshop.art.paint.ColourRamp;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.SphereNoise;
import org.joml.Vector3d;

/**
 * Painter of a night sky between the planets: a band of distant stars with dark lanes, dim clouds of gas, and near
 * stars in their colours.
 */
final class StarPainter {
    private static final int WIDTH = 1024;
    private static final int HEIGHT = 768;
    private static final int FAINT_STARS = 2600;
    private static final int BRIGHT_STARS = 90;

    private static final PaintColour NIGHT = PaintColour.of(0x05070D);
    private static final PaintColour BAND = PaintColour.of(0x8E8A94);
    private static final PaintColour HEART = PaintColour.of(0xE6C9A4);
    private static final PaintColour ROSE = PaintColour.of(0x7A2F4E);
    private static final PaintColour BLUE = PaintColour.of(0x1D3E73);
    private static final ColourRamp STARLIGHT = ColourRamp.of(0xFFB98A, 0xFFE2BF, 0xFFFFFF, 0xDCE8FF, 0xA9C6FF);

    private final SphereNoise dust = new SphereNoise(1009);
    private final SeededNoise chance = new SeededNoise(1013);
    private final PaintColour[] pixels = new PaintColour[WIDTH * HEIGHT];

    static BufferedImage paint() {
        return new StarPainter().picture();
    }

    private BufferedImage picture() {
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = glow(i % WIDTH + 0.5, i / WIDTH + 0.5);
        }
        for (int i = 0; i < FAINT_STARS; i++) {
            star(i, 0.4 + 0.5 * chance.unit(i, 3, 1) * chance.unit(i, 3, 2), 0.55);
        }
        for (int i = 0; i < BRIGHT_STARS; i++) {
            double size = chance.unit(i, 3, 5);
            star(FAINT_STARS + i, 1.1 + 1.5 * size * size, 0.75 + 0.75 * size * size);
        }
        return Pixels.picture(WIDTH, HEIGHT, (column, row) -> pixels[row * WIDTH + column].rgb());
    }

    /**
     * Returns the distance from the band's middle line as a fraction of the picture's height; the band rises to the
     * right.
     */
    private static double across(double x, double y) {
        return (y / HEIGHT - 0.62) + 0.42 * (x / WIDTH - 0.5);
    }

    private PaintColour glow(double x, double y) {
        Vector3d p = new Vector3d(3 * x / HEIGHT, 3 * y / HEIGHT, 0.5);
        Vector3d torn = dust.warped(p, 0.9, 4, 0.35);
        double away = across(x, y) + 0.05 * dust.cloud(p, 0.8, 3);
        double band = 1 - Shapes.ramp(0, 0.26, Math.abs(away));
        double lane =
                (1 - Shapes.ramp(0, 0.1, Math.abs(away + 0.02))) * Shapes.ramp(-0.1, 0.5, dust.cloud(torn, 2.2, 6));
        double heart = 1 - Shapes.ramp(0, 0.5, Math.abs(x / WIDTH - 0.68) * 1.2 + Math.abs(away) * 2);
        double light = band * (0.5 + 0.45 * dust.cloud(torn, 1.6, 6));
        PaintColour sky = NIGHT.mix(BLUE, 0.3 * Shapes.ramp(-0.1, 0.8, dust.cloud(p, 0.7, 4)));
        sky = sky.mix(ROSE, 0.3 * band * Shapes.ramp(0.1, 0.7, dust.cloud(torn, 1.1, 5)));
        sky = sky.mix(BAND, 0.46 * Math.max(0, light)).mix(HEART, 0.3 * heart * Math.max(0, light));
        return sky.mix(NIGHT, 0.75 * lane);
    }

    /** Draws a star, dimmer if it is away from the band; brightness 1 fills a pixel with white. */
    private void star(int i, double brightness, double radius) {
        double x = WIDTH * chance.unit(i, 0, 0);
        double y = HEIGHT * chance.unit(i, 1, 0);
        boolean far = Math.abs(across(x, y)) > 0.16 && i < FAINT_STARS;
        double weight = far ? 0.55 * brightness : brightness;
        PaintColour light = STARLIGHT.at(chance.unit(i, 2, 0));
        for (int row = (int) y - 4; row <= (int) y + 4; row++) {
            for (int column = (int) x - 4; column <= (int) x + 4; column++) {
                shine(column, row, light, weight * spread(column + 0.5 - x, row + 0.5 - y, radius));
            }
        }
    }

    private static double spread(double dx, double dy, double radius) {
        double squared = (dx * dx + dy * dy) / (radius * radius);
        double core = StrictMath.exp(-squared);
        double halo = 0.12 / (1 + squared * squared);
        return core + halo * (1 - Shapes.ramp(2.5, 4.5, Math.sqrt(dx * dx + dy * dy)));
    }

    private void shine(int column, int row, PaintColour light, double fraction) {
        if (column >= 0 && row >= 0 && column < WIDTH && row < HEIGHT) {
            int at = row * WIDTH + column;
            pixels[at] = pixels[at].mix(light, Math.min(1, fraction));
        }
    }
}
