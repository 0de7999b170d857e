package nephele.engine.render;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderFeature.Role;
import nephele.engine.render.frame.RenderResources;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.CopiedPlanes;

/** The passes that a request requires, in frame order, and the drawing of those that belong to each view. */
final class FramePasses {
    private static final Set<Target> OF_A_VIEW = EnumSet.of(Target.VIEW_DEPTH, Target.VIEW_COLOUR);

    /** All passes, and the feature of each. */
    private final List<Pass> all = new ArrayList<>();

    private final List<RenderFeature> features = new ArrayList<>();
    private final List<Pass> inViews;
    private final List<Pass> depthReaders;
    private final List<Pass> colourReaders;
    /** The number of passes in views before {@link Stage#IN_VIEWS_AFTER_OPAQUE}. */
    private final int opaque;

    FramePasses(RenderResources resources, Decoration decoration, List<RenderFeature> registered) {
        for (FramePlan.Step step : FramePlan.of(resources.request(), registered).steps()) {
            if (decoration == Decoration.ON || step.feature().role() != Role.DECORATION) {
                for (Required required : step.required()) {
                    add(step.feature(), required.build().apply(resources.context(step.feature())));
                }
            }
        }
        inViews = of(feature -> feature.stage() == Stage.IN_VIEWS || feature.stage() == Stage.IN_VIEWS_AFTER_OPAQUE);
        opaque = of(Stage.IN_VIEWS).size();
        depthReaders = readers(Target.VIEW_DEPTH);
        colourReaders = readers(Target.VIEW_COLOUR);
    }

    private void add(RenderFeature feature, Pass pass) {
        Stage stage = feature.stage();
        if (!features.isEmpty() && features.get(features.size() - 1).stage().compareTo(stage) > 0) {
            throw new IllegalStateException(
                    feature.name() + " is of stage " + stage + ", but stands after a pass of a later one");
        }
        if (stage != Stage.IN_VIEWS_AFTER_OPAQUE && pass.reads().stream().anyMatch(OF_A_VIEW::contains)) {
            throw new IllegalStateException(feature.name() + " reads a copy of its view, but is of stage " + stage);
        }
        features.add(feature);
        all.add(pass);
    }

    private List<Pass> of(Predicate<RenderFeature> wanted) {
        List<Pass> found = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            if (wanted.test(features.get(i))) {
                found.add(all.get(i));
            }
        }
        return List.copyOf(found);
    }

    private List<Pass> readers(Target target) {
        return all.stream().filter(pass -> pass.reads().contains(target)).toList();
    }

    boolean isEmpty() {
        return all.isEmpty();
    }

    List<Pass> of(Stage stage) {
        return of(feature -> feature.stage() == stage);
    }

    /** Returns the passes of each view, in order. */
    List<Pass> inViews() {
        return inViews;
    }

    /** Returns the passes that draw the background of a view. */
    List<Pass> skies() {
        return of(feature -> feature.role() == Role.SKY);
    }

    /** Returns the targets that any pass reads. */
    Set<Target> reads() {
        Set<Target> reads = EnumSet.noneOf(Target.class);
        all.forEach(pass -> reads.addAll(pass.reads()));
        return reads;
    }

    /** Returns the names of the passes, with the clear between the passes of all views and those of each view. */
    List<String> stepNames() {
        List<String> names = new ArrayList<>();
        features.forEach(feature -> names.add(feature.name()));
        names.add(of(Stage.ONCE_A_FRAME).size(), "clear");
        return List.copyOf(names);
    }

    /** Draws a view, with copies of it for the passes that read them. */
    void drawView(FrameContext frame, ViewCopies copies) {
        for (int i = 0; i < inViews.size(); i++) {
            drawInView(i, frame, copies);
        }
    }

    /** Draws one pass of a view. */
    void drawInView(int index, FrameContext frame, ViewCopies copies) {
        if (index == opaque) {
            CopiedPlanes needed = neededCopies(frame);
            if (needed != null) {
                copies.take(frame.surface(), needed);
            }
        }
        inViews.get(index).draw(frame);
    }

    /** Returns what passes read in this view; {@code null} for nothing. */
    private CopiedPlanes neededCopies(FrameContext frame) {
        boolean isDepth = isNeeded(depthReaders, frame);
        if (isNeeded(colourReaders, frame)) {
            return isDepth ? CopiedPlanes.COLOUR_AND_DEPTH : CopiedPlanes.COLOUR;
        }
        return isDepth ? CopiedPlanes.DEPTH : null;
    }

    private static boolean isNeeded(List<Pass> readers, FrameContext frame) {
        for (int i = 0; i < readers.size(); i++) {
            if (readers.get(i).needsCopies(frame)) {
                return true;
            }
        }
        return false;
    }
}
