package nephele.engine.render.pass.cloud;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.drawn.TechniqueFade;
import nephele.engine.level.CloudTechnique;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.render.resource.FrameClouds;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.resource.RendererClouds;

/**
 * The clouds of a level with their drawings, in the order in which they are drawn. While techniques change, a cloud has a
 * drawing by each of them, the later ones over the earlier ones; those of techniques that are gone are closed.
 */
final class CloudEntries {
    private final RendererClouds levelClouds;
    private final boolean hasLightning;
    private final List<CloudDrawing.Technique> techniques;
    private final List<Entry> all = new ArrayList<>();
    /** Builds what ends with the change; {@code null} without one. */
    private LoadContext passing;

    private final List<FrameClouds> passingClouds = new ArrayList<>();

    /**
     * A cloud with its drawing by one technique.
     *
     * @param clouds sampled for that technique
     * @param stages of the change in which the technique draws the cloud
     * @param flashed draws the light of a flash in the cloud; {@code null} without lightning, and for a technique that goes
     */
    record Entry(
            PlacedCloud cloud,
            FrameClouds clouds,
            List<List<CloudTechnique>> stages,
            CloudDrawing drawing,
            CloudDrawing flashed) {
        CloudDrawing drawing(CloudPixels pixels) {
            return pixels.isLook() ? drawing : flashed;
        }

        boolean isDrawn() {
            return cloud.presence() > 0 && cloud.fractionDrawn() > 0;
        }

        private void follow(FrameContext frame, boolean isFlash, TechniqueFade fade) {
            double drawn = 0;
            for (List<CloudTechnique> stage : stages) {
                drawn += fade.fraction(stage);
            }
            cloud.fractionDrawn(Math.min(1, drawn));
            CloudInterval now = clouds.now();
            cloud.follow(now);
            drawing.follow(frame.frameState().environment(), now);
            if (isFlash && flashed != null && flashed != drawing) {
                flashed.follow(frame.frameState().environment(), now);
            }
        }
    }

    /**
     * Builds the drawings.
     *
     * @param clouds by the techniques that remain
     * @param techniques the one for {@code auto} first
     */
    CloudEntries(CloudContext context, List<PlacedCloud> clouds, List<CloudDrawing.Technique> techniques) {
        levelClouds = context.load().get(RendererClouds.RESOURCE);
        hasLightning = context.load().get(FrameLightning.RESOURCE) != null;
        this.techniques = techniques;
        TechniqueFade fade = levelClouds.fade();
        List<PassingStage> stages = fade.isComplete() ? List.of() : stages(context.load(), fade);
        for (PlacedCloud cloud : clouds) {
            if (stages.isEmpty()) {
                all.add(remaining(cloud, List.of(fade.techniques()), context));
            } else {
                addRuns(cloud, stages, context);
            }
        }
    }

    /** The techniques of a stage with the clouds that are sampled for them. */
    private record PassingStage(List<CloudTechnique> techniques, FrameClouds clouds) {}

    private List<PassingStage> stages(LoadContext load, TechniqueFade fade) {
        passing = load.ownedBy(load.own(new OwnedObjects(load.gl())));
        List<PassingStage> stages = new ArrayList<>();
        for (TechniqueFade.Stage stage : fade.stages()) {
            boolean remains = stage.techniques().equals(fade.techniques());
            FrameClouds clouds =
                    remains ? levelClouds.current() : levelClouds.sampledFor(stage.techniques(), passing.owner());
            if (!remains) {
                passingClouds.add(clouds);
            }
            stages.add(new PassingStage(stage.techniques(), clouds));
        }
        return stages;
    }

    /** Adds a drawing for each run of stages in which the cloud has one technique. */
    private void addRuns(PlacedCloud cloud, List<PassingStage> stages, CloudContext context) {
        int first = 0;
        while (first < stages.size()) {
            int end = first + 1;
            while (end < stages.size() && technique(stages.get(end), cloud) == technique(stages.get(first), cloud)) {
                end++;
            }
            List<PassingStage> run = stages.subList(first, end);
            List<List<CloudTechnique>> runTechniques =
                    run.stream().map(PassingStage::techniques).toList();
            boolean remains = runTechniques.contains(levelClouds.fade().techniques());
            all.add(
                    remains
                            ? remaining(cloud, runTechniques, context)
                            : passing(cloud, run.get(0), runTechniques, context));
            first = end;
        }
    }

    private static CloudTechnique technique(PassingStage stage, PlacedCloud cloud) {
        return source(stage, cloud).cloud().technique();
    }

    private static CloudSource source(PassingStage stage, PlacedCloud cloud) {
        return stage.clouds.sources().get(cloud.index());
    }

    private Entry passing(
            PlacedCloud cloud, PassingStage stage, List<List<CloudTechnique>> stages, CloudContext context) {
        var before = new PlacedCloud(source(stage, cloud), cloud.index());
        var own = new CloudContext(passing.with(levelClouds.chosenFor(stages.get(0))), null, context.ranges());
        CloudDrawing drawing = drawn(before.source()).build().apply(own, before);
        return new Entry(before, stage.clouds, stages, drawing, null);
    }

    private Entry remaining(PlacedCloud cloud, List<List<CloudTechnique>> stages, CloudContext context) {
        CloudDrawing.Technique technique = drawn(cloud.source());
        CloudDrawing drawing = technique.build().apply(context, cloud);
        // Flashes light the cells of a cloud whatever draws it, by the technique for auto.
        CloudDrawing.Technique marched = techniques.get(0);
        CloudDrawing flashed = !hasLightning
                ? null
                : technique == marched ? drawing : marched.build().apply(context, cloud);
        return new Entry(cloud, levelClouds.current(), stages, drawing, flashed);
    }

    /** Returns the technique of a cloud; the first one for {@code auto} and where the authored one cannot draw it. */
    private CloudDrawing.Technique drawn(CloudSource cloud) {
        return techniques.stream()
                .filter(known -> known.technique() == cloud.cloud().technique()
                        && known.canDraw().test(cloud))
                .findFirst()
                .orElse(techniques.get(0));
    }

    List<Entry> all() {
        return all;
    }

    /** Takes the clouds at the time of the frame, the farthest from an eye first. */
    void follow(FrameContext frame, boolean isFlash) {
        TechniqueFade fade = levelClouds.fade();
        if (passing != null && fade.isComplete()) {
            all.removeIf(entry -> entry.clouds != levelClouds.current());
            passingClouds.clear();
            passing.owner().close();
            passing = null;
        }
        Vec3 eye = frame.view().eye();
        for (FrameClouds clouds : passingClouds) {
            clouds.follow(frame.frameState(), levelClouds.current().focus());
        }
        for (int i = 0; i < all.size(); i++) {
            all.get(i).follow(frame, isFlash, fade);
        }
        for (int i = 0; i < all.size(); i++) {
            all.get(i).drawing.prepare(frame.view());
        }
        if (all.size() > 1) {
            all.sort(Comparator.comparingDouble(entry -> -entry.cloud.distance(eye)));
        }
    }
}
