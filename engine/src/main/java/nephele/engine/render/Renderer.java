package nephele.engine.render;

import java.util.List;
import java.util.OptionalDouble;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.DrawnScene;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderResources;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.CopiedPlanes;
import nephele.engine.render.gl.DrawState.DepthOf;
import nephele.engine.render.gl.DrawState.Fill;
import nephele.engine.render.gl.DrawState.Stencil;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.resource.AmbientLight;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.PictureHistory;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.ViewTree;
import nephele.engine.scene.VisibleSet;
import nephele.engine.scene.probe.SkyProbes;

/** One level on the GPU, with the passes that it requires and no others. */
public final class Renderer implements AutoCloseable {
    private final GlContext gl;
    private final RenderSettings settings;
    private final List<RenderFeature> features;
    private final Scene scene;
    private final RenderResources resources;
    private final VisibleSet visible;
    private final FrameState start;
    // Set when the passes are known.
    private FramePasses passes;
    private List<Pass> onceAFrame;
    private List<Pass> afterViews;
    private List<Pass> afterAll;
    private PictureChain chain;
    private ViewCopies copies;
    private Multisampling multisampling;
    /** {@code null} in a level that cannot have portals. */
    private PortalViews portals;
    /** {@code null} if no pass draws clouds or is lit through them. */
    private RendererClouds clouds;

    private SkyProbes probes;
    /** {@code null} if exposure is not metered. */
    private MeteredExposure exposure;

    /** {@code null} if frames are not averaged. */
    private PictureHistory history;

    private FrameContext frame;
    /** The main view of the frame before; {@code null} at first. */
    private View viewBefore;

    private Renderer(
            OwnedObjects owned,
            DrawnScene drawn,
            RenderSettings settings,
            List<RenderFeature> features,
            RenderResources replaced) {
        gl = owned.gl();
        scene = drawn.scene();
        this.settings = settings;
        this.features = features;
        FrameRequest request = FrameRequest.of(
                scene.level(),
                scene.statics(),
                scene.light() == null ? null : scene.light().indirect(),
                settings.output(),
                settings.quality(),
                settings.character());
        resources = new RenderResources(owned, drawn, request, replaced);
        start = FrameState.atStart(scene.level());
        visible = scene.solids().isEmpty() ? null : new VisibleSet(scene.solids());
    }

    /**
     * Builds what a level requires of a list of features.
     *
     * @param owned closed with the renderer, and if it cannot be built
     * @throws nephele.engine.asset.AssetException that names a picture that cannot be used
     */
    public static Renderer load(
            OwnedObjects owned, DrawnScene drawn, RenderSettings settings, List<RenderFeature> features) {
        return load(new Renderer(owned, drawn, settings, features, null));
    }

    private static Renderer load(Renderer renderer) {
        try {
            renderer.buildPasses();
            return renderer;
        } catch (RuntimeException e) {
            renderer.close();
            throw e;
        }
    }

    /**
     * Returns a renderer of the edited level and closes this one. Unchanged data stay on the GPU; shadow maps that
     * changed are drawn again with the next frame.
     *
     * @param owned closed with the new renderer
     * @param edited a scene derived from this renderer's
     * @throws nephele.engine.asset.AssetException that names a picture that cannot be used; this renderer then stays
     * open
     */
    public Renderer edited(OwnedObjects owned, DrawnScene edited) {
        return replacedBy(new Renderer(owned, edited, settings, features, null));
    }

    /**
     * Returns a renderer of the edited level as {@link #edited} does, in which clouds that the edit leaves as they are
     * change from the techniques of this one to their new ones in the time that {@link #elapse} receives.
     */
    public Renderer editedGradually(OwnedObjects owned, DrawnScene edited) {
        return replacedBy(new Renderer(owned, edited, settings, features, resources));
    }

    private Renderer replacedBy(Renderer built) {
        Renderer next = load(built);
        next.follow(this);
        close();
        return next;
    }

    /**
     * Lets time pass in which an edit is taken over gradually.
     *
     * @param seconds of the display; {@link Double#POSITIVE_INFINITY} to end the change
     */
    public void elapse(double seconds) {
        if (clouds != null) {
            clouds.elapse(seconds);
        }
    }

    /** Returns how far an edit has been taken over, 1 for a picture that no {@link #elapse} changes. */
    public double changed() {
        return clouds == null ? 1 : clouds.changed();
    }

    private void buildPasses() {
        RenderFeatures.OF_EVERY_VIEW.forEach(resources::get);
        passes = new FramePasses(resources, settings.decoration(), features);
        onceAFrame = passes.of(Stage.ONCE_A_FRAME);
        afterViews = passes.of(Stage.AFTER_VIEWS);
        afterAll = passes.of(Stage.AFTER_ALL);
        exposure = resources.get(MeteredExposure.RESOURCE);
        clouds = resources.ifMade(RendererClouds.RESOURCE);
        probes = resources.ifMade(AmbientLight.PROBES);
        history = resources.ifMade(PictureHistory.RESOURCE);
        resources.forgetReplaced();
        chain = new PictureChain(gl, resources.request(), afterAll.size());
        copies = new ViewCopies(gl, resources.targets(), passes.reads());
        multisampling = new Multisampling(gl, settings.quality().samples(), copies.areRead());
        if (!passes.isEmpty()) {
            resources.uniforms().samplePositions(multisampling.positions());
        }
        if (ViewTree.mayGrow(scene.level())) {
            portals = new PortalViews(gl, settings, resources, scene, passes, copies);
        }
        frame = new FrameContext(portals);
    }

    /** Returns the context in which it draws. */
    public GlContext gl() {
        return gl;
    }

    /** Returns the scene that this renderer draws. */
    public Scene scene() {
        return scene;
    }

    /**
     * Returns the names of a frame's steps, in order: the passes that all views share, the clear, then the other
     * passes.
     */
    public List<String> stepNames() {
        return passes.stepNames();
    }

    /** Called after each step's draw calls have been submitted; used for timing. */
    @FunctionalInterface
    public interface StepListener {
        StepListener NONE = step -> {};

        /** @param step index into {@link #stepNames} */
        void submitted(int step);
    }

    /** Draws one view of the level in its state before the first tick. */
    public void draw(View view, RenderTarget picture) {
        draw(view, start, picture);
    }

    /** Draws as {@link #draw(View, RenderTarget)} does, and calls {@code listener} after each step. */
    public void draw(View view, RenderTarget picture, StepListener listener) {
        draw(view, start, picture, listener);
    }

    /** Draws one view over the whole of {@code picture}; does nothing if that has no pixels, as a minimised window. */
    public void draw(View view, FrameState frameState, RenderTarget picture) {
        draw(view, frameState, picture, StepListener.NONE);
    }

    /** Draws as {@link #draw(View, FrameState, RenderTarget)} does, and calls {@code listener} after each step. */
    public void draw(View view, FrameState frameState, RenderTarget picture, StepListener listener) {
        gl.state().resetCounts();
        if (picture.width() == 0 || picture.height() == 0) {
            return;
        }
        // Another renderer of this context, another toolkit or a recording may have changed them.
        gl.state().fill(Fill.WHOLE);
        gl.state().stencil(Stencil.OFF, 0);
        gl.state().depthOf(DepthOf.SURFACE);
        RenderTarget surface = chain.surface(picture);
        RenderTarget drawn = multisampling.inPlaceOf(surface, surface.format());
        frame.begin(frameState, drawn);
        frame.setView(view, null, null, null);
        resources.follow(frame);
        if (!passes.isEmpty()) {
            begin(view, frameState, surface);
            drawOnce(listener);
        }
        if (exposure != null) {
            exposure.begin(frameState, picture);
            if (exposure.needsDrawingBefore()) {
                meterBefore(frameState, surface, drawn);
            }
        }
        clear(frameState, surface, drawn);
        if (passes.inViews().isEmpty()) {
            average(surface);
        }
        listener.submitted(onceAFrame.size());
        drawView(surface, listener);
        drawAfterViews(surface, listener);
        drawAfterAll(picture, listener);
    }

    private void clear(FrameState frameState, RenderTarget surface, RenderTarget drawn) {
        if (portals != null) {
            // Views with pictures of their own are drawn first: it is costly to continue in a target after a switch to
            // another one.
            portals.drawPictures(frameState, surface, drawn);
        }
        Vec3 behind = resources.environment().clearColour();
        drawn.clear(behind.x(), behind.y(), behind.z(), resources.request().skyAlpha());
    }

    /** Draws the views only to meter them: what shows values of the display in them needs the exposure. */
    private void meterBefore(FrameState frameState, RenderTarget surface, RenderTarget drawn) {
        clear(frameState, surface, drawn);
        for (int i = 0; i < passes.inViews().size(); i++) {
            passes.drawInView(i, frame, copies);
        }
        multisampling.resolve(surface);
        drawAfterViews(surface, StepListener.NONE);
        frame.begin(frameState, drawn);
    }

    private void begin(View view, FrameState frameState, RenderTarget surface) {
        ViewNode root = portals == null ? null : portals.choose(view, frameState, surface);
        View before = portals == null || viewBefore == null ? viewBefore : portals.followed(viewBefore);
        if (before != viewBefore) {
            cut();
        }
        if (history != null) {
            history.begin(before, view, surface);
            resources.shift(history.acrossShift(), history.upShift());
        }
        viewBefore = view;
        if (visible != null) {
            settings.culling().find(visible, view);
        }
        resources.setView(view);
        frame.setView(view, root, visible, settings.limits(root));
    }

    private void drawOnce(StepListener listener) {
        for (int i = 0; i < onceAFrame.size(); i++) {
            onceAFrame.get(i).draw(frame);
            listener.submitted(i);
        }
    }

    private void drawView(RenderTarget surface, StepListener listener) {
        int size = passes.inViews().size();
        for (int i = 0; i < size; i++) {
            passes.drawInView(i, frame, copies);
            if (i + 1 == size) {
                average(surface);
            }
            listener.submitted(onceAFrame.size() + 1 + i);
        }
    }

    private void drawAfterViews(RenderTarget surface, StepListener listener) {
        for (int i = 0; i < afterViews.size(); i++) {
            frame.setPictures(surface, null);
            afterViews.get(i).draw(frame);
            listener.submitted(onceAFrame.size() + 1 + passes.inViews().size() + i);
        }
    }

    private void drawAfterAll(RenderTarget picture, StepListener listener) {
        int first = onceAFrame.size() + 1 + passes.inViews().size() + afterViews.size();
        for (int i = 0; i < afterAll.size(); i++) {
            frame.setPictures(chain.before(i, picture), chain.before(i + 1, picture));
            afterAll.get(i).draw(frame);
            listener.submitted(first + i);
        }
    }

    /** Averages the samples; afterwards the surface's pixels can be read. */
    private void average(RenderTarget surface) {
        multisampling.resolve(surface);
        remember(surface);
    }

    private void remember(RenderTarget surface) {
        if (portals != null && !passes.isEmpty()) {
            portals.end(surface);
        }
    }

    /**
     * Drops the history of pictures after a cut: the deepest openings of the next picture take nothing from it, and its
     * exposure is metered from it alone. Views whose rays several frames share begin anew.
     */
    public void forget() {
        cut();
        if (exposure != null) {
            exposure.forget();
        }
        if (history != null) {
            history.forget();
        }
        if (portals != null) {
            portals.forget();
        }
    }

    private void cut() {
        if (probes != null) {
            probes.cut();
        }
        if (clouds != null) {
            clouds.cut();
        }
    }

    /**
     * Returns the linear radiance of the last frame before exposure, RGB, the bottom row first; only for output HDR.
     * It has the pixels that were drawn: fewer than the picture if {@code pictureResolution} is below 1.
     */
    public float[] readRadiance() {
        return chain.readRadiance();
    }

    /**
     * Returns what {@link #readRadiance} returns with as many pixels as {@code picture} has: fewer are scaled up
     * bilinearly.
     */
    public float[] readRadianceOf(RenderTarget picture) {
        RenderTarget drawn = chain.radiance();
        if (drawn.width() == picture.width() && drawn.height() == picture.height()) {
            return drawn.readFloats();
        }
        try (var scaled =
                RenderTarget.picture(gl, "radiance", PixelFormat.RGBA16F, picture.width(), picture.height())) {
            copyRadiance(scaled);
            return scaled.readFloats();
        }
    }

    /** Copies what {@link #readRadiance} returns to a target of any size, sampled bilinearly. */
    public void copyRadiance(RenderTarget target) {
        chain.radiance().copyScaledTo(target);
    }

    /**
     * Copies the depth of the last frame's surfaces to its picture, for lines that are drawn over it. Views that have a
     * target of their own, as for output HDR, leave the picture's depth as it was.
     */
    public void copyDepth(RenderTarget picture) {
        RenderTarget surface = chain.surface(picture);
        if (surface != picture) {
            surface.copyTo(picture, CopiedPlanes.DEPTH);
        }
    }

    /** Continues the adaption of exposure of another renderer of this context, which it replaces. */
    public void follow(Renderer replaced) {
        if (exposure != null && replaced.exposure != null) {
            exposure.follow(replaced.exposure);
        }
    }

    /** Returns the exposure of the last frame in stops, if it is metered; waits for the GPU. */
    public OptionalDouble readMeteredStops() {
        return exposure == null ? OptionalDouble.empty() : OptionalDouble.of(exposure.readStops());
    }

    /** Returns the number of frames of a view at rest after which its picture is final. */
    public int framesToSettle() {
        return history == null ? 1 : 2 * PictureHistory.POINTS;
    }

    /** Returns the number of views through openings in the last frame. */
    public int viewsDrawn() {
        return portals == null ? 0 : portals.drawn();
    }

    /** Returns the number of draw calls of the last frame. */
    public long draws() {
        return gl.state().draws();
    }

    /** Returns the number of triangles submitted in the last frame. */
    public long triangles() {
        return gl.state().triangles();
    }

    @Override
    public void close() {
        resources.close();
        if (copies != null) {
            chain.close();
            copies.close();
            multisampling.close();
        }
        if (portals != null) {
            portals.close();
        }
    }
}
