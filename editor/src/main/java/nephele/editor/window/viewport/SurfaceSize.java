package nephele.editor.window.viewport;

import java.awt.Component;
import java.awt.GraphicsConfiguration;

/**
 * The size of a surface.
 *
 * @param width in physical pixels, at least 1
 * @param pixelsPerPoint physical pixels for a unit of Swing: 1 on an ordinary display, 2 at 200 %
 */
public record SurfaceSize(int width, int height, double pixelsPerPoint) {
    static SurfaceSize of(Component component) {
        GraphicsConfiguration screen = component.getGraphicsConfiguration();
        double scale = screen == null ? 1 : screen.getDefaultTransform().getScaleX();
        return new SurfaceSize(pixels(component.getWidth(), scale), pixels(component.getHeight(), scale), scale);
    }

    private static int pixels(int points, double scale) {
        return Math.max(1, (int) Math.round(points * scale));
    }
}
