package nephele.engine.render.resource;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.drawn.TechniqueFade;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.render.frame.DrawnScene;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.OwnedObjects;

/**
 * The clouds of a renderer's level, sampled for the techniques that draw them. After an edit that leaves the clouds as
 * they are, these change gradually from those of the replaced renderer.
 */
public final class RendererClouds {
    public static final SharedResource<RendererClouds> RESOURCE =
            SharedResource.of("clouds", RendererClouds::new).following((clouds, frame) -> clouds.follow(frame));

    private final LoadContext context;
    private final FrameClouds current;
    private final Map<List<CloudTechnique>, DrawnScene> chosenFor = new HashMap<>();
    private TechniqueFade fade;
    private int cuts;

    private RendererClouds(LoadContext context) {
        this.context = context;
        DrawnScene drawn = context.drawn();
        RendererClouds before = context.resources().replaced(RESOURCE);
        TechniqueFade start = TechniqueFade.complete(drawn.techniques());
        if (before != null && causes(drawn).equals(causes(before.context.drawn()))) {
            start = before.fade;
            chosenFor.putAll(before.chosenFor);
        }
        fade = start.towards(drawn.techniques());
        chosenFor.put(drawn.techniques(), drawn);
        chosenFor
                .keySet()
                .retainAll(fade.stages().stream()
                        .map(TechniqueFade.Stage::techniques)
                        .toList());
        current = sampledFor(drawn.techniques(), context.owner());
    }

    private void follow(FrameContext frame) {
        if (!current.sources().isEmpty()) {
            current.follow(frame.frameState(), frame.view().eye());
        }
    }

    private static Environment causes(DrawnScene drawn) {
        return CloudTimeline.causes(drawn.scene().level().environment());
    }

    /** Returns the clouds as sampled for these techniques, shared between renderers. */
    public FrameClouds sampledFor(List<CloudTechnique> techniques, OwnedObjects owner) {
        return FrameClouds.of(context.ownedBy(owner), techniques);
    }

    /** Returns the clouds as sampled for the techniques that remain. */
    public FrameClouds current() {
        return current;
    }

    /** Returns the techniques that draw the clouds, several while they change. */
    public TechniqueFade fade() {
        return fade;
    }

    /** Returns the scene for which techniques were chosen, this one or one before an edit. */
    public DrawnScene chosenFor(List<CloudTechnique> techniques) {
        return chosenFor.get(techniques);
    }

    /** Returns how far the techniques have changed, 1 without a change. */
    public double changed() {
        return fade.isComplete() ? 1 : fade.fraction(fade.target());
    }

    /** Lets the time of the display pass, in which techniques change. */
    public void elapse(double seconds) {
        if (!fade.isComplete()) {
            fade = fade.after(seconds);
        }
    }

    /** Notes that the next frame has nothing to do with those before it. */
    public void cut() {
        cuts++;
    }

    /** Returns the number of cuts so far: history that was made before the last one is void. */
    public int cuts() {
        return cuts;
    }
}
