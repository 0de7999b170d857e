package nephele.engine.render;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.RenderResources;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderFeature.Role;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;

/** The passes that a request requires, in frame order, ordered by stage. */
final class PassOrder {
    private static final Set<Target> OF_A_VIEW = EnumSet.of(Target.VIEW_DEPTH, Target.VIEW_COLOUR);

    private record Entry(RenderFeature feature, Pass pass) {}

    private final List<Entry> entries = new ArrayList<>();

    PassOrder(RenderResources resources, Decoration decoration, List<RenderFeature> features) {
        for (FramePlan.Step step : FramePlan.of(resources.request(), features).steps()) {
            if (decoration == Decoration.ON || step.feature().role() != Role.DECORATION) {
                for (Required required : step.required()) {
                    add(step.feature(), required.build().apply(resources.context(step.feature())));
                }
            }
        }
    }

    private void add(RenderFeature feature, Pass pass) {
        Stage stage = feature.stage();
        if (!entries.isEmpty()
                && entries.get(entries.size() - 1).feature.stage().compareTo(stage) > 0) {
            throw new IllegalStateException(
                    feature.name() + " is of stage " + stage + ", but stands after a pass of a later one");
        }
        if (stage != Stage.IN_VIEWS_AFTER_OPAQUE && pass.reads().stream().anyMatch(OF_A_VIEW::contains)) {
            throw new IllegalStateException(feature.name() + " reads a copy of its view, but is of stage " + stage);
        }
        entries.add(new Entry(feature, pass));
    }

    boolean isEmpty() {
        return entries.isEmpty();
    }

    /** Returns the index of the first pass of {@code stage} or a later one. */
    private int begin(Stage stage) {
        return (int) entries.stream()
                .filter(entry -> entry.feature.stage().compareTo(stage) < 0)
                .count();
    }

    List<Pass> of(Stage stage) {
        return passes(entry -> entry.feature.stage() == stage);
    }

    private List<Pass> passes(Predicate<Entry> wanted) {
        return entries.stream().filter(wanted).map(Entry::pass).toList();
    }

    ViewPasses views() {
        int first = begin(Stage.IN_VIEWS);
        List<Pass> all = passes(entry ->
                entry.feature.stage() == Stage.IN_VIEWS || entry.feature.stage() == Stage.IN_VIEWS_AFTER_OPAQUE);
        List<Pass> skies = passes(entry -> entry.feature.role() == Role.SKY);
        return new ViewPasses(
                all,
                skies,
                begin(Stage.IN_VIEWS_AFTER_OPAQUE) - first,
                passes(entry -> entry.pass.reads().contains(Target.VIEW_DEPTH)),
                passes(entry -> entry.pass.reads().contains(Target.VIEW_COLOUR)));
    }

    /** Returns the targets that any pass reads. */
    Set<Target> reads() {
        Set<Target> reads = EnumSet.noneOf(Target.class);
        entries.forEach(entry -> reads.addAll(entry.pass.reads()));
        return reads;
    }

    /** Returns the names of the passes, with the clear between the passes of all views and those of each view. */
    List<String> stepNames() {
        List<String> names = new ArrayList<>();
        entries.forEach(entry -> names.add(entry.feature.name()));
        names.add(begin(Stage.IN_VIEWS), "clear");
        return List.copyOf(names);
    }
}
