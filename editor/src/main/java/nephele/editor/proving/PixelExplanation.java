package nephele.editor.proving;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nephele.editor.document.LevelShapes;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.level.Brush;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedExposure;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.VisibleSurface;
import nephele.engine.render.FramePlan;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.scene.light.LevelLight;
import nephele.host.draw.QualityChoice;

/**
 * What a pixel of the perspective pane shows, and why: the surface at the end of its sight, the light that the reference
 * tracer finds there, and the passes that the level requires.
 *
 * @param lines in the user's language; the passes in English, as {@code nephele explain} prints them
 */
public record PixelExplanation(List<String> lines) {
    private static final int SAMPLES = 256;
    private static final double ON_FACE_METRES = 1e-3;

    /** Explains a pixel, on any thread; takes a moment, as it traces rays. */
    static PixelExplanation of(Level level, AssetSource assets, Language language, PaneEye eye, PaneEye.Pixel pixel) {
        List<String> lines = new ArrayList<>();
        lines.add(ProvingText.PIXEL
                .with(
                        pixel.x(),
                        pixel.y(),
                        eye.size().width(),
                        eye.size().height(),
                        place(eye.camera().eye()))
                .in(language));
        try {
            PlacedLevel placed = PlacedLevel.of(level, assets);
            PlacedLevel exposed = TracedExposure.fixed(placed, ColourDecoding.SRGB, eye.pinhole(), 0);
            TracedLevel traced = TracedLevel.of(exposed, ColourDecoding.SRGB);
            addSight(lines, language, level, traced.sight(eye.pinhole(pixel)), eye);
            addLight(lines, language, exposed.level(), traced, eye, pixel);
            lines.add("");
            lines.add(ProvingText.PASSES.in(language));
            FramePlan.of(FrameRequest.of(placed, LevelLight.stored(placed).light(), QualityChoice.defaultOutput(level)))
                    .explain()
                    .forEach(line -> lines.add("  " + line));
        } catch (AssetException | IllegalArgumentException unusable) {
            lines.add(unusable.getMessage());
        }
        return new PixelExplanation(List.copyOf(lines));
    }

    private static void addSight(
            List<String> lines, Language language, Level level, VisibleSurface sight, PaneEye eye) {
        int index = sight.at(0.5, 0.5);
        if (index == VisibleSurface.NOTHING) {
            lines.add(ProvingText.SEES_NOTHING.in(language));
        } else {
            lines.add(ProvingText.SEES
                    .with(name(level, index), place(sight.place()))
                    .in(language));
            face(level, index, sight.place())
                    .ifPresent(face -> lines.add(ProvingText.FACE
                            .with(
                                    face.name(),
                                    face.material(),
                                    (face.portalable() ? ProvingText.TAKES_PORTALS : ProvingText.TAKES_NONE)
                                            .in(language),
                                    number(sight.place()
                                            .minus(eye.camera().eye())
                                            .length()))
                            .in(language)));
        }
        if (sight.pathHash() != 0) {
            lines.add(ProvingText.ON_THE_WAY.in(language));
        }
    }

    private static String name(Level level, int index) {
        int solids = level.solids().size();
        int bodies = level.bodies().size();
        if (index < solids) {
            return "solids/" + level.solids().get(index).id();
        }
        return index < solids + bodies
                ? "bodies/" + level.bodies().get(index - solids).id()
                : "models/" + level.models().get(index - solids - bodies).id();
    }

    private static Optional<Brush.BrushFace> face(Level level, int index, Vec3 at) {
        if (index >= level.solids().size()) {
            return Optional.empty();
        }
        return LevelShapes.of(level).brush(level.solids().get(index)).stream()
                .flatMap(brush -> brush.faces().stream())
                .filter(face -> Math.abs(face.plane().signedDistance(at)) < ON_FACE_METRES)
                .findFirst();
    }

    private static void addLight(
            List<String> lines, Language language, Level level, TracedLevel traced, PaneEye eye, PaneEye.Pixel pixel) {
        float[] radiance = ReferencePicture.trace(
                traced, eye.pinhole(pixel), new TraceSettings(1, 1, SAMPLES, 1, 1), fraction -> {});
        Picture displayed = TracedCorner.TraceProgress.picture(radiance, 1, level);
        lines.add(ProvingText.LIGHT
                .with(
                        number(radiance[0]) + " " + number(radiance[1]) + " " + number(radiance[2]),
                        SAMPLES,
                        String.format(
                                Locale.ROOT,
                                "#%02x%02x%02x",
                                displayed.sample(0, 0, 0),
                                displayed.sample(0, 0, 1),
                                displayed.sample(0, 0, 2)))
                .in(language));
    }

    private static String place(Vec3 at) {
        return number(at.x()) + ", " + number(at.y()) + ", " + number(at.z());
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.3f", value + 0.0);
    }

    /** Returns the lines as one text. */
    public String text() {
        return String.join("\n", lines);
    }
}
