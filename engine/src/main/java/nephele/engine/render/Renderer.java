package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.ClearColour;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Moment;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.ViewTree;
import nephele.engine.scene.VisibleSet;

/** One level on the GPU, with the passes that it requires and nothing else. */
public final class Renderer implements AutoCloseable {
    private final GlContext gl;
    private final RenderSettings settings;
    private final Scene scene;
    private final SharedResources shared;
    private final List<Pass> passes = new ArrayList<>();
    private final List<String> stepNames = new ArrayList<>(List.of("clear"));
    private final ClearColour clearColour;
    private final VisibleSet visible;
    private final Moment start;
    private final Multisampling multisampling;
    /** {@code null} in a level where portals cannot be. */
    private PortalViews portals;

    private FrameContext frame;
    private RenderTarget linear;
    /** So many passes come before the first one that reads the surface's pixels. */
    private int surfacePasses;

    private Renderer(GlContext gl, Scene scene, RenderSettings settings) {
        this.gl = gl;
        this.scene = scene;
        this.settings = settings;
        this.shared = new SharedResources(gl, scene);
        this.multisampling = new Multisampling(gl, settings.quality().samples());
        this.clearColour = ClearColour.of(scene.level().environment(), settings.output());
        this.start = Moment.atStart(scene.level());
        this.visible = scene.solids().isEmpty() ? null : new VisibleSet(scene.solids());
    }

    /**
     * Builds what the level requires.
     *
     * @throws nephele.engine.asset.AssetException naming a picture that cannot be used
     */
    public static Renderer load(GlContext gl, Level level, AssetSource assets, RenderSettings settings) {
        return load(gl, Scene.of(level, assets), settings);
    }

    /** As {@link #load(GlContext, Level, AssetSource, RenderSettings)}, from a scene that was derived elsewhere. */
    public static Renderer load(GlContext gl, Scene scene, RenderSettings settings) {
        return load(gl, scene, settings, RenderFeatures.ALL);
    }

    /** As if no other feature were registered than these. */
    static Renderer load(GlContext gl, Scene scene, RenderSettings settings, List<RenderFeature> features) {
        Renderer renderer = new Renderer(gl, scene, settings);
        try {
            renderer.buildPasses(features);
            return renderer;
        } catch (RuntimeException e) {
            renderer.close();
            throw e;
        }
    }

    private void buildPasses(List<RenderFeature> features) {
        LoadContext context =
                new LoadContext(gl, scene, settings.output(), settings.quality(), settings.figure(), shared);
        for (FramePlan.Step step : FramePlan.forLevel(scene.level(), settings.output(), settings.figure(), features)
                .steps()) {
            for (Required required : step.required()) {
                Pass pass = required.build().apply(gl);
                if (settings.decoration() == Decoration.ON || !pass.isDecoration()) {
                    passes.add(pass);
                    stepNames.add(step.feature().name());
                    pass.load(context);
                }
            }
        }
        if (ViewTree.mayGrow(scene.level())) {
            portals = portalViews();
        }
        frame = new FrameContext(portals);
        while (surfacePasses < passes.size()
                && !passes.get(surfacePasses).reads().contains(Target.SURFACE)) {
            surfacePasses++;
        }
    }

    private PortalViews portalViews() {
        List<Pass> inEveryView = passes.stream().filter(Pass::inEveryView).toList();
        return new PortalViews(gl, settings, shared, scene, inEveryView);
    }

    private double exposure() {
        return ClearColour.exposure(scene.level().environment());
    }

    public Scene scene() {
        return scene;
    }

    /** What a frame consists of, in order: the clear, then the passes. */
    public List<String> stepNames() {
        return List.copyOf(stepNames);
    }

    /** Hears when each step of a frame has been submitted: for timing. */
    @FunctionalInterface
    public interface StepListener {
        StepListener NONE = step -> {};

        /** @param step index into {@link #stepNames} */
        void submitted(int step);
    }

    /** Draws one view of the level as it is before the first tick. */
    public void draw(View view, RenderTarget picture) {
        draw(view, start, picture);
    }

    /** As {@link #draw(View, RenderTarget)}, telling {@code listener} after each step. */
    public void draw(View view, RenderTarget picture, StepListener listener) {
        draw(view, start, picture, listener);
    }

    /** Draws one view over the whole of {@code picture}; nothing when that has no pixels, as a minimised window. */
    public void draw(View view, Moment moment, RenderTarget picture) {
        draw(view, moment, picture, StepListener.NONE);
    }

    /** As {@link #draw(View, Moment, RenderTarget)}, telling {@code listener} after each step. */
    public void draw(View view, Moment moment, RenderTarget picture, StepListener listener) {
        gl.state().resetCounts();
        if (picture.width() == 0 || picture.height() == 0) {
            return;
        }
        RenderTarget surface = settings.output() == Output.HDR ? linear(picture) : picture;
        RenderTarget drawn = multisampling.inPlaceOf(surface, surfaceFormat(picture));
        // Pictures of their own come first: drawing on in a target after another one is costly.
        ViewNode root = portals == null ? null : portals.begin(view, moment, picture, drawn, surfaceFormat(picture));
        drawn.clear(clearColour.red(), clearColour.green(), clearColour.blue());
        if (surfacePasses == 0) {
            multisampling.resolve(surface);
        }
        listener.submitted(0);
        if (passes.isEmpty()) {
            return;
        }
        if (visible != null) {
            settings.culling().find(visible, view);
        }
        shared.frameUniforms().upload(view, exposure());
        frame.into(moment, surfacePasses == 0 ? surface : drawn, picture);
        frame.see(view, root, visible);
        drawPasses(surface, listener);
    }

    private void drawPasses(RenderTarget surface, StepListener listener) {
        for (int i = 0; i < passes.size(); i++) {
            passes.get(i).draw(frame);
            if (i + 1 == surfacePasses) {
                multisampling.resolve(surface);
                frame.into(surface);
                remember(surface);
            }
            listener.submitted(i + 1);
        }
    }

    private void remember(RenderTarget surface) {
        if (portals != null) {
            portals.end(frame.moment(), surface, surfaceFormat(frame.picture()));
        }
    }

    /** The next picture has nothing to do with the last one: the deepest openings take nothing from it. */
    public void forget() {
        if (portals != null) {
            portals.forget();
        }
    }

    private PixelFormat surfaceFormat(RenderTarget picture) {
        if (settings.output() == Output.HDR) {
            return PixelFormat.RGBA16F;
        }
        return picture.colour() == null ? PixelFormat.RGBA8 : picture.colour().format();
    }

    private RenderTarget linear(RenderTarget picture) {
        if (linear == null || linear.width() != picture.width() || linear.height() != picture.height()) {
            closeLinear();
            linear = RenderTarget.picture(gl, "linear picture", PixelFormat.RGBA16F, picture.width(), picture.height());
        }
        return linear;
    }

    /** Linear radiance before exposure of the last frame, RGB, the bottom row first; only for output HDR. */
    public float[] readRadiance() {
        if (linear == null) {
            throw new IllegalStateException("radiance can be read after a frame with output HDR");
        }
        return linear.readFloats();
    }

    /** Views through portals that the last frame drew. */
    public int viewsDrawn() {
        return portals == null ? 0 : portals.drawn();
    }

    /** Draw calls of the last frame. */
    public long draws() {
        return gl.state().draws();
    }

    /** Triangles submitted in the last frame. */
    public long triangles() {
        return gl.state().triangles();
    }

    private void closeLinear() {
        if (linear != null) {
            linear.close();
            linear = null;
        }
    }

    @Override
    public void close() {
        passes.forEach(Pass::close);
        shared.close();
        multisampling.close();
        closeLinear();
        if (portals != null) {
            portals.close();
        }
    }
}
