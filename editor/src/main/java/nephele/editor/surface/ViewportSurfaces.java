package nephele.editor.surface;

import java.awt.GraphicsEnvironment;
import java.util.Locale;
import java.util.function.Consumer;
import nephele.engine.render.gl.GlContext;

/** Chooses the surface that works on this system. */
public final class ViewportSurfaces {
    private ViewportSurfaces() {}

    /**
     * Returns a surface.
     *
     * @param report receives one line if the surface is not the one that the mode names first, and why; also later, when
     * the first picture is drawn
     */
    public static ViewportSurface choose(SurfaceMode mode, SurfacePainter painter, Consumer<String> report) {
        String objection = objection(mode);
        if (objection.isEmpty()) {
            try {
                return new FallbackSurface(painter, () -> offscreen(painter), reason -> report.accept(told(reason)));
            } catch (LinkageError unusable) {
                objection = String.valueOf(unusable.getMessage());
            }
        }
        if (mode == SurfaceMode.AWT) {
            report.accept(told(objection));
        }
        return offscreen(painter);
    }

    private static ViewportSurface offscreen(SurfacePainter painter) {
        return new OffscreenSurface(painter, GlContext::offscreen);
    }

    private static String told(String reason) {
        return "the viewport is drawn offscreen: " + reason;
    }

    /** Returns why no canvas is tried, or an empty text. */
    private static String objection(SurfaceMode mode) {
        if (mode == SurfaceMode.OFFSCREEN) {
            return "as asked for";
        }
        if (GraphicsEnvironment.isHeadless()) {
            return "there is no display";
        }
        String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        return system.contains("linux") ? "" : "the library of canvases works on X11 only";
    }
}
