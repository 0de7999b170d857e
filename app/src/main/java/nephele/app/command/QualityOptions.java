package nephele.app.command;

import java.util.LinkedHashMap;
import java.util.Map;
import nephele.engine.draw.QualityChoice;
import picocli.CommandLine.Option;

/** The quality options that all drawing commands share. */
final class QualityOptions {
    @Option(
            names = "--quality",
            paramLabel = "Q",
            defaultValue = "high",
            description =
                    "low, medium, high, ultra or auto, as play draws them: low with half the resolution, scaled up;"
                            + " auto as play begins (default: high).")
    private String quality;

    @Option(
            names = "--set",
            paramLabel = "KEY=VALUE",
            parameterConsumer = SettingConsumer.class,
            description =
                    "Change single settings: pictureResolution, upscale, anisotropy, normalMaps, brdf, shadowTexels,"
                            + " shadowFilter, lightShadows, samples, edgeFilter, portalTechnique, viewBudget,"
                            + " portalResolution, cloudResolution, cloudHistory, cloudStep, cloudLightCell,"
                            + " cloudScattering, billboardFacing, particleLight, impostors, impostorErrorPixels,"
                            + " skyplaneShape, proceduralNoise, cloudSkyboxTexels, terrainDetail, terrainErrorPixels,"
                            + " terrainLayers, lightParts, impostorPixels, spriteCoverage, culling, narrowing, rims;"
                            + " debug=ids draws every solid in its own colour.")
    private Map<String, String> settings = new LinkedHashMap<>();

    QualityChoice choice() {
        var choice = new QualityChoice(quality, settings);
        choice.check();
        return choice;
    }
}
