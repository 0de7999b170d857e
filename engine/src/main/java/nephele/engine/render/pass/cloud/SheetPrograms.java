package nephele.engine.render.pass.cloud;

import java.util.function.Function;
import nephele.engine.render.gl.FullScreenTriangle;

/**
 * The programs of a technique that draws clouds as sheets, and the triangle that they are run over.
 *
 * @param <P> the places of what else a program has
 */
public final class SheetPrograms<P> {
    private final PerPixels<SheetProgram<P>> programs;
    private final FullScreenTriangle triangle;

    public SheetPrograms(CloudContext context, String name, Function<CloudPixels, SheetProgram<P>> compile) {
        programs = new PerPixels<>(compile);
        triangle = context.load().own(new FullScreenTriangle(context.load().gl(), name));
    }

    /** Uses the program of a canvas for a cloud; returns the places of what else is to be set. */
    public P use(CloudCanvas canvas, PlacedCloud placed, LitCloud lit) {
        return programs.of(canvas.pixels()).use(canvas, placed, lit);
    }

    public void draw() {
        triangle.draw();
    }
}
