package nephele.app.play;

import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.line.LineDrawing;
import nephele.engine.render.line.LineLayer;
import nephele.engine.render.line.LineProjection;
import nephele.engine.scene.View;
import nephele.host.playthrough.ObserverView;

/** Draws the outlines of the bounds that an observer's sphere can touch, over the picture. */
public final class BoundOutlines implements AutoCloseable {
    private static final DisplayColour COLOUR = DisplayColour.of(0xFFD24A, 0.8);
    private static final double WIDTH_PIXELS = 1.5;

    private final GlContext gl;
    private final LineCanvas canvas = new LineCanvas();
    private LineDrawing drawing;

    /** Creates no GL object before there is an observer. */
    public BoundOutlines(GlContext gl) {
        this.gl = gl;
    }

    /** @param observer {@code null} for no outlines */
    public void draw(ObserverView observer, View view, RenderTarget picture) {
        if (observer == null) {
            return;
        }
        if (drawing == null) {
            drawing = new LineDrawing(gl);
        }
        canvas.begin(LineProjection.of(view, picture.width(), picture.height()));
        List<Vec3> ends = observer.outlines();
        for (int i = 0; i < ends.size(); i += 2) {
            canvas.line(ends.get(i), ends.get(i + 1), COLOUR, WIDTH_PIXELS, LineLayer.OVER_ALL);
        }
        drawing.draw(canvas, picture);
    }

    @Override
    public void close() {
        if (drawing != null) {
            drawing.close();
        }
    }
}
