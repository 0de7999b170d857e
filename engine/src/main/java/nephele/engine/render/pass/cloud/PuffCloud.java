package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.level.Environment;

/** A cloud that is divided into balls, drawn by one of the programs for them. */
final class PuffCloud implements CloudDrawing {
    private final PlacedCloud placed;
    private final PerPixels<PuffProgram> programs;
    private final LitCloud cells;
    private final PuffQuads quads;
    /** {@code null} if it is always drawn ball by ball, as is the following. */
    private final Impostors impostors;

    private final Impostor impostor;
    private DrawnCloud shownFrom;
    private DrawnCloud shownTo;
    private double shownShare;
    private CloudPuffs from;
    private CloudPuffs to;
    /** The puffs at the time of the frame; {@code null} until something needs them. */
    private CloudPuffs now;

    PuffCloud(CloudContext context, PlacedCloud placed, PerPixels<PuffProgram> programs) {
        this.placed = placed;
        this.programs = programs;
        cells = new LitCloud(context.load(), placed);
        quads = context.load().own(new PuffQuads(context.load().gl()));
        impostors = context.impostors();
        impostor = impostors == null
                ? null
                : impostors.add(context, new Impostor(context.load().gl(), placed, cells, programs, this::balls));
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
            now = null;
        }
        if (impostor != null) {
            impostor.follow(from, to);
        }
    }

    /** Returns the balls at the time of the frame. */
    private CloudPuffs balls() {
        if (now == null) {
            now = from.towards(to, shownShare);
        }
        return now;
    }

    @Override
    public void draw(CloudCanvas canvas) {
        if (impostors != null && impostors.draw(impostor, canvas)) {
            return;
        }
        programs.of(canvas.pixels()).use(canvas, placed, cells);
        quads.show(balls(), canvas.view().eye().minus(placed.drift()), placed.presence());
        quads.draw();
    }
}
