package nephele.lab.trade.subject;

import java.util.List;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import nephele.engine.asset.Picture;
import nephele.engine.model.Mesh;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;
import nephele.lab.trade.subject.XmlPictureExperiment.Variant;
import nephele.scenes.fixed.SceneFiles;
import nephele.scenes.fixed.Shading;
import nephele.scenes.xml.XmlModel;
import nephele.scenes.xml.XmlScene;

/** Parameters of XML scenes: where lighting is evaluated, how finely surfaces are tessellated, the normals of cones. */
public final class SceneSubjects {
    private static final int EXACT_SLICES = 256;
    private static final int USUAL_SLICES = 32;
    private static final int CONE_SLICES = 64;
    private static final String EXACT = "in 256 slices, lit at each of 16 points a pixel, whose light is averaged";

    public static final Trade SHADING = of(
            "shading",
            new Trade.Text(
                    "Where light is worked out",
                    "XML scenes are lit by the light model of fixed-function OpenGL: once a triangle, at its vertices"
                            + " and blended between them, or at every pixel. Round things have " + USUAL_SLICES
                            + " slices here.",
                    "the same surfaces " + EXACT),
            1,
            List.of(
                    new Setting("flat", "facets show"),
                    new Setting("gouraud", "as OpenGL did it; highlights smear over a triangle"),
                    new Setting("phong", "blends the normals and lights each pixel")),
            files -> Stream.of(Shading.FLAT, Shading.GOURAUD, Shading.PHONG)
                    .map(shading -> new Variant(StillLife.of(USUAL_SLICES), files, shading))
                    .toList(),
            StillLife::of);

    public static final Trade TESSELLATION = of(
            "tessellation",
            new Trade.Text(
                    "How many triangles a round thing takes",
                    "Slices and stacks of the generator's primitives, and a quarter as many parts a patch of the"
                            + " teapot, lit at the vertices: with more of them both outline and light come closer.",
                    "the same surfaces " + EXACT),
            3,
            List.of(
                    new Setting("4", "angular"),
                    Setting.of("8"),
                    Setting.of("16"),
                    Setting.of("32"),
                    Setting.of("64"),
                    new Setting("128", "some triangles as small as pixels")),
            files -> Stream.of(4, 8, 16, 32, 64, 128)
                    .map(slices -> new Variant(StillLife.of(slices), files, Shading.GOURAUD))
                    .toList(),
            StillLife::of);

    public static final Trade CONE_NORMALS = of(
            "coneNormals",
            new Trade.Text(
                    "Which way a cone's side faces",
                    "The scene-engine report gives a point of a cone's side the normal (r sin a, cos(atan(h / R)), r"
                        + " cos a) with the radius r there, which is right on one ring only and straight up at the"
                        + " tip. The generator takes the slope: (h sin a, R, h cos a) made unit. Both cost the same.",
                    "cones " + EXACT),
            1,
            List.of(
                    new Setting("report", "radius 1, height 2: 63° off at the tip, 15° halfway up"),
                    new Setting("exact", "the generator's")),
            files -> Stream.of(withReportCones(files), files)
                    .map(cones -> new Variant(StillLife.cones(CONE_SLICES), cones, Shading.PHONG))
                    .toList(),
            StillLife::cones);

    private SceneSubjects() {}

    /** Returns the same meshes, but the sides of cones have the normals of the scene-engine report. */
    private static SceneFiles withReportCones(SceneFiles files) {
        return new SceneFiles() {
            @Override
            public Mesh mesh(XmlModel model) {
                String[] name = model.file().split("_");
                Mesh mesh = files.mesh(model);
                return name[0].equals("cone")
                        ? withReportNormals(mesh, Double.parseDouble(name[1]), Double.parseDouble(name[2]))
                        : mesh;
            }

            @Override
            public Picture picture(XmlModel model) {
                return files.picture(model);
            }
        };
    }

    /**
     * The report's side normal is (r sin a, cos(atan(h / R)), r cos a), with the radius r at the point; it is not of
     * unit length.
     */
    static Mesh withReportNormals(Mesh cone, double radius, double height) {
        float[] normals = cone.normals().clone();
        float up = (float) Math.cos(Math.atan(height / radius));
        for (int i = 0; i < normals.length; i += 3) {
            boolean isSide = normals[i + 1] > 0;
            if (isSide) {
                normals[i] = cone.positions()[i];
                normals[i + 1] = up;
                normals[i + 2] = cone.positions()[i + 2];
            }
        }
        return new Mesh(cone.positions(), normals, cone.textureCoordinates(), cone.indices());
    }

    /** @param scene makes a scene from a number of slices */
    private static Trade of(
            String subject,
            Trade.Text text,
            int usual,
            List<Setting> settings,
            Function<StillLife.Generated, List<Variant>> variants,
            IntFunction<XmlScene> scene) {
        return new Trade(
                subject,
                text,
                List.of(),
                settings,
                usual,
                new ErrorMetric("mean FLIP", "", 5e-4, 2e-3),
                XmlPictureExperiment.FIGURES,
                CostMetric.FRAME,
                null,
                site -> {
                    var files = new StillLife.Generated();
                    var exact = new Variant(scene.apply(EXACT_SLICES), files, Shading.PHONG);
                    return new XmlPictureExperiment(site, exact, variants.apply(files));
                });
    }
}
