package nephele.engine.level;

/** Bodies whose numbers contradict each other. */
final class BodyRules {
    static final LevelRule SHAPES = (level, assets, report) -> {
        for (int i = 0; i < level.bodies().size(); i++) {
            if (level.bodies().get(i) instanceof Body.Capsule capsule
                    && capsule.heightMetres() < 2 * capsule.radiusMetres()) {
                report.accept(Problem.error(
                        "bodies[" + i + "].heightMetres",
                        "a capsule is at least as high as it is wide: make it " + 2 * capsule.radiusMetres()
                                + " or more, or a sphere"));
            }
        }
    };

    private BodyRules() {}
}
