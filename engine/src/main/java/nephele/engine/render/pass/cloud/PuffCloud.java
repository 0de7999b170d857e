package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.level.Environment;
import nephele.engine.render.frame.LoadContext;

/** A cloud that is divided into balls, drawn by one of the programs for them. */
final class PuffCloud implements CloudDrawing {
    private final PlacedCloud placed;
    private final PerPixels<PuffProgram> programs;
    private final LitCloud cells;
    private final PuffQuads quads;
    private DrawnCloud shownFrom;
    private DrawnCloud shownTo;
    private double shownShare;
    private CloudPuffs from;
    private CloudPuffs to;
    private CloudPuffs now;

    PuffCloud(LoadContext context, PlacedCloud placed, PerPixels<PuffProgram> programs) {
        this.placed = placed;
        this.programs = programs;
        cells = new LitCloud(context, placed);
        quads = context.own(new PuffQuads(context.gl()));
    }

    @Override
    public void follow(Environment environment, CloudInterval interval) {
        cells.follow(environment, interval);
        boolean isSame = cells.shown() == shownFrom && cells.toCome() == shownTo;
        if (!isSame) {
            from = cells.shown() == shownTo ? to : CloudPuffs.of(cells.shown());
            to = cells.toCome() == cells.shown() ? from : CloudPuffs.of(cells.toCome());
            shownFrom = cells.shown();
            shownTo = cells.toCome();
        }
        if (!isSame || cells.share() != shownShare) {
            shownShare = cells.share();
            now = from.towards(to, shownShare);
        }
    }

    @Override
    public void draw(CloudCanvas canvas) {
        programs.of(canvas.pixels()).use(canvas, placed, cells);
        quads.show(now, canvas.view().eye().minus(placed.drift()), placed.presence());
        quads.draw();
    }
}
