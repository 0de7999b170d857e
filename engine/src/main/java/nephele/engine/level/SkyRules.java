package nephele.engine.level;

/** As many files as the layout of a skybox needs. */
final class SkyRules {
    static final LevelRule FILES = (level, assets, report) -> {
        if (level.environment().sky() instanceof Sky.Skybox skybox) {
            int wanted = skybox.layout() == SkyboxLayout.FACES ? 6 : 1;
            if (skybox.files().size() != wanted) {
                String layout = WordFormats.Choice.word(skybox.layout());
                report.accept(Problem.error(
                        "environment.sky.files",
                        "layout " + layout + " needs " + wanted + " files, not "
                                + skybox.files().size()));
            }
        }
    };

    private SkyRules() {}
}
