package nephele.workshop.prove.portals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.function.Function;
import java.util.stream.Stream;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.host.named.LevelCatalogue;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Shoots two portals horizontally from eye height and walks straight at the first: with the usual assists, without any,
 * and with the usual ones pushing or carrying a cube. Units alternate between generated rooms and the levels of the
 * checkout, all with the same cube and without their own portals and bodies.
 */
public final class WalkInProof implements Proof {
    private static final int ROOMS = 20;
    private static final int SHOTS_PER_PLACE = 10;
    private static final int MOST_DRAWS = 4000;
    private static final int MOST_WALKS = 30;
    private static final double NEAREST_METRES = 0.5;
    private static final double FARTHEST_METRES = 4;
    private static final double STEEPEST_DEGREES = 70;
    private static final int BIN_DEGREES = 10;

    /** Longest time for a walk beyond that of its path at half of the speed. */
    private static final double MORE_SECONDS = 1.5;

    private static final double AFTER_SECONDS = 0.25;
    private static final double CARRY_SECONDS = 1;
    /** Distance before the player's centre at which a cube lies that it pushes or picks up. */
    private static final double CUBE_AHEAD_METRES = 0.75;

    /** How far down a player looks at a cube to pick it up. */
    private static final int LOOK_MILLIDEGREES = 62_000;

    /** Path that a player with a cube may walk besides. */
    private static final double MORE_METRES = 12;

    private static final double HITS_METRES = 1e-3;
    private static final int TICKS_PER_SECOND = 120;
    private static final double MOST_REFUSED = 0.02;

    private static final String SHOTS = "shots";
    private static final String REFUSED = "shots refused";
    /** The aperture would fit without the other portal. */
    private static final String TAKEN = "shots refused for the other portal";

    private static final String NO_GROUND = "shots without free ground before the portal";
    private static final String PLAIN = "walks without assists";
    private static final String HOLDING = "cubes still carried";
    private static final String THROUGH = " through";
    private static final String DEGREES = " degrees";

    /** How a player walks at a portal. */
    private enum Walk {
        BARE("walks", 0.995),
        PUSHING("walks that push", 0.99),
        CARRYING("walks that carry", 0.99);

        private final String figure;
        /** The fraction that has to go through. */
        private final double least;

        Walk(String figure, double least) {
            this.figure = figure;
            this.least = least;
        }

        /** Returns the figure of the walks at an angle to the portal's normal. */
        private String at(double degrees) {
            int bin = (int) (Math.abs(degrees) / BIN_DEGREES) * BIN_DEGREES;
            return figure + " at " + bin + " to " + (bin + BIN_DEGREES) + DEGREES;
        }
    }

    @Override
    public Claim claim() {
        return new Claim(
                "walk-in",
                "Of horizontal shots at eye height at walls that take portals to the floor, at most 2 % are refused,"
                        + " those apart where the other portal is in the way; of straight walks at such a portal's"
                        + " centre, from 0.5 to 4 m and up to 70 degrees, 99.5 % go through without a jump, and 99 %"
                        + " with a cube pushed or carried.",
                "walks",
                5_000,
                500);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        Range range = new Range(places(), progress);
        for (long unit = from; unit < from + count; unit++) {
            range.walk(unit);
            progress.unitsDone(unit + 1 - from);
        }
        return range.result(count);
    }

    /** Gives fractions in place of sums of what went through, and fails where they are too small. */
    @Override
    public ProofResult judged(ProofResult soFar) {
        List<Figure> figures = new ArrayList<>();
        List<String> failures = new ArrayList<>();
        for (Figure figure : soFar.figures()) {
            if (figure.name().endsWith(THROUGH)) {
                String of = figure.name().substring(0, figure.name().length() - THROUGH.length());
                figures.add(Figure.least(figure.name(), 100 * figure.value() / soFar.value(of), "%"));
            } else if (!figure.name().endsWith(DEGREES)) {
                figures.add(figure);
            }
        }
        for (Walk walk : Walk.values()) {
            if (soFar.value(walk.figure + THROUGH) < walk.least * soFar.value(walk.figure)) {
                failures.add("too few " + walk.figure + " go through");
            }
        }
        if (soFar.value(REFUSED) > MOST_REFUSED * soFar.value(SHOTS)) {
            failures.add("too many shots are refused");
        }
        int failed = failures.size();
        failures.addAll(soFar.examples());
        return new ProofResult(soFar.units(), failed, figures, failures);
    }

    /** Returns the places to shoot in, each of which is read when its turn comes. */
    private static List<Callable<WalkInPlace>> places() throws IOException {
        List<Callable<WalkInPlace>> places = new ArrayList<>();
        for (int i = 0; i < ROOMS; i++) {
            int number = i;
            places.add(() -> new WalkInPlace("room " + number, WalkInRooms.of(number)));
        }
        for (String folder : List.of("levels", "levels/samples")) {
            if (Files.isDirectory(Path.of(folder))) {
                try (Stream<Path> files = Files.list(Path.of(folder))) {
                    files.filter(LevelCatalogue::isLevel).sorted().forEach(file -> places.add(() -> level(file)));
                }
            }
        }
        return places;
    }

    private static WalkInPlace level(Path file) throws LevelFormatException {
        LevelFile.Opened opened = LevelFile.load(file);
        return new WalkInPlace(file.toString(), PlacedLevel.of(opened.level(), opened.assets()));
    }

    /** A range of units and what was counted in it. */
    private static final class Range {
        private final List<Callable<WalkInPlace>> sources;
        private final Progress progress;
        private final Map<Integer, Site> sites = new HashMap<>();
        private final Map<String, Double> sums = new LinkedHashMap<>();
        private final List<String> examples = new ArrayList<>();

        Range(List<Callable<WalkInPlace>> sources, Progress progress) {
            this.sources = sources;
            this.progress = progress;
            // In the order in which they are shown.
            for (String name : List.of(SHOTS, REFUSED, TAKEN, NO_GROUND)) {
                add(name, 0);
            }
            for (Walk walk : Walk.values()) {
                add(walk.figure, 0);
                add(walk.figure + THROUGH, 0);
                for (int degrees = 0; degrees < STEEPEST_DEGREES; degrees += BIN_DEGREES) {
                    add(walk.at(degrees), 0);
                    add(walk.at(degrees) + THROUGH, 0);
                }
            }
        }

        private void add(String name, double more) {
            sums.merge(name, more, Double::sum);
        }

        /** Counts a walk, and one that went through. */
        private void add(String name, boolean through) {
            add(name, 1);
            add(name + THROUGH, through ? 1 : 0);
        }

        ProofResult result(long count) {
            List<Figure> figures = new ArrayList<>();
            sums.forEach((name, sum) -> figures.add(Figure.sum(name, sum, "")));
            return new ProofResult(count, 0, figures, examples);
        }

        /** Walks once, in the first place from the unit's own on where shots can be drawn. */
        void walk(long unit) throws Exception {
            SplittableRandom random = new SplittableRandom(unit ^ 0x5DEECE66DL);
            int first = (int) (unit / SHOTS_PER_PLACE % sources.size());
            for (int i = 0; i < sources.size(); i++) {
                int at = (first + i) % sources.size();
                Site site = site(at);
                if (site != null && walk(unit, site, random)) {
                    return;
                }
                sites.put(at, null);
            }
            throw new IllegalStateException("no place has walls to shoot at");
        }

        private Site site(int at) throws Exception {
            if (!sites.containsKey(at)) {
                WalkInPlace place = sources.get(at).call();
                sites.put(at, place.hasWalls() ? new Site(place) : null);
            }
            return sites.get(at);
        }

        /** Returns false if the place has no two walls to shoot at. */
        private boolean walk(long unit, Site site, SplittableRandom random) {
            for (int attempt = 0; attempt < MOST_WALKS; attempt++) {
                PlayerState one = site.draw(random);
                PlayerState two = one == null ? null : site.draw(random);
                if (two == null) {
                    return false;
                }
                SimState aided = shot(site, site.aided, one, two);
                if (aided == null) {
                    continue;
                }
                double angle = random.nextDouble(-STEEPEST_DEGREES, STEEPEST_DEGREES);
                double metres = random.nextDouble(NEAREST_METRES, FARTHEST_METRES);
                if (walk(unit, site, aided, metres, angle)) {
                    plain(site, one, two, metres, angle);
                    return true;
                }
            }
            return false;
        }

        /** Returns the state after both shots, {@code null} if one is refused or has no free ground. */
        private SimState shot(Site site, Simulation simulation, PlayerState one, PlayerState two) {
            SimState state = simulation.start();
            for (GunPortals.Colour colour : GunPortals.Colour.BOTH) {
                boolean first = colour == GunPortals.Colour.FIRST;
                SimState fired = Site.fired(
                        simulation,
                        state.withPlayer(first ? one : two),
                        first ? Action.FIRE_FIRST : Action.FIRE_SECOND);
                if (simulation == site.aided && !hitsOtherPortal(fired)) {
                    count(fired);
                }
                if (fired.world().shots().portal(colour) == GunPortals.UNFIRED) {
                    return null;
                }
                state = fired;
            }
            if (simulation == site.aided) {
                for (int i = 0; i < 2; i++) {
                    if (!site.place.hasGroundBefore(state.world().portals().portal(i))) {
                        add(NO_GROUND, 1);
                        return null;
                    }
                }
            }
            return state;
        }

        /** Returns true if a shot was refused because it hits the other portal, which is no wall any more. */
        private static boolean hitsOtherPortal(SimState fired) {
            for (TickEvent event : fired.world().trace().events()) {
                if (event instanceof TickEvent.PortalRefused refused
                        && refused.reason() == Refusal.OVERLAPS_OTHER
                        && fired.world().portals().size() > 0) {
                    Portal other = fired.world().portals().portal(0);
                    Vec3 at = refused.where();
                    return Math.abs(other.inFront(at.x(), at.y(), at.z())) < HITS_METRES
                            && other.aperture()
                                            .outside(
                                                    other.across(at.x(), at.y(), at.z()),
                                                    other.upward(at.x(), at.y(), at.z()))
                                    <= HITS_METRES;
                }
            }
            return false;
        }

        private void count(SimState fired) {
            add(SHOTS, 1);
            for (TickEvent event : fired.world().trace().events()) {
                if (event instanceof TickEvent.PortalRefused refused) {
                    add(refused.reason() == Refusal.OVERLAPS_OTHER ? TAKEN : REFUSED, 1);
                }
            }
        }

        private boolean walk(long unit, Site site, SimState state, double metres, double angle) {
            Portal portal = state.world().portals().portal(0);
            PlayerState start = site.place.before(portal, metres, Math.toRadians(angle));
            if (start == null) {
                return false;
            }
            String where = String.format(
                    Locale.ROOT,
                    "%d in %s: not through from %.2f m at %.1f degrees: %s, %s",
                    unit,
                    site.place.name,
                    metres,
                    angle,
                    portal.centre(),
                    portal.normal());
            count(Walk.BARE, angle, where, site.goesThrough(site.aided, state.withPlayer(start), metres));
            if (metres > CUBE_AHEAD_METRES + WalkInPlace.CUBE_METRES) {
                Vec3 ahead = WalkInPlace.turned(portal.normal(), Math.toRadians(angle))
                        .negated();
                SimState withCube = site.withCube(state.withPlayer(start), start.feet(), ahead);
                count(Walk.PUSHING, angle, where, site.pushesThrough(withCube, metres));
                SimState holding = site.carrying(withCube);
                if (holding != null) {
                    count(Walk.CARRYING, angle, where, site.goesThrough(site.aided, holding, metres + FARTHEST_METRES));
                    add(HOLDING, site.stillHolds ? 1 : 0);
                }
            }
            return true;
        }

        /**
         * Counts a walk.
         *
         * @param angle from which it comes to the portal's normal, in degrees
         * @param where describes a walk that did not go through
         */
        private void count(Walk walk, double angle, String where, boolean through) {
            add(walk.figure, through);
            add(walk.at(angle), through);
            if (!through) {
                String example = walk.figure + " " + where;
                progress.failed(example);
                examples.add(example);
            }
        }

        private void plain(Site site, PlayerState one, PlayerState two, double metres, double angle) {
            SimState state = shot(site, site.plain, one, two);
            PlayerState start = state == null
                    ? null
                    : site.place.before(state.world().portals().portal(0), metres, Math.toRadians(angle));
            if (start != null) {
                add(PLAIN, site.goesThrough(site.plain, state.withPlayer(start), metres));
            }
        }
    }

    /** A place with its simulations. */
    private static final class Site {
        private final WalkInPlace place;
        private final Simulation aided;
        private final Simulation plain;
        private boolean stillHolds;

        Site(WalkInPlace place) {
            this.place = place;
            aided = new Simulation(place.level, new SimSettings(TICKS_PER_SECOND, Assist.USUAL));
            plain = new Simulation(place.level, new SimSettings(TICKS_PER_SECOND, List.of()));
        }

        PlayerState draw(SplittableRandom random) {
            for (int i = 0; i < MOST_DRAWS; i++) {
                PlayerState shooter = place.shooter(random);
                if (shooter != null) {
                    return shooter;
                }
            }
            return null;
        }

        static SimState fired(Simulation simulation, SimState state, Action action) {
            return simulation.step(state, PlayerInput.NONE.holding(action));
        }

        /** Returns a state with the cube on the ground before the player. */
        SimState withCube(SimState state, Vec3 feet, Vec3 ahead) {
            Vec3 centre = feet.addScaled(CUBE_AHEAD_METRES, ahead)
                    .addScaled(WalkInPlace.CUBE_METRES / 2 + 0.01, new Vec3(0, 1, 0));
            return state.with(state.world().with(state.world().bodies().with(0, BodyState.resting(centre))));
        }

        /** Returns a state in which the player has picked up the cube, {@code null} if it cannot. */
        SimState carrying(SimState before) {
            PlayerInput down = PlayerInput.NONE.turning(0, -LOOK_MILLIDEGREES);
            SimState state = aided.step(before, down);
            state = aided.step(state, PlayerInput.NONE.holding(Action.CARRY));
            state = aided.step(state, PlayerInput.NONE.turning(0, LOOK_MILLIDEGREES));
            for (int i = 0; i < CARRY_SECONDS * TICKS_PER_SECOND; i++) {
                state = aided.step(state, PlayerInput.NONE);
            }
            return state.world().holding().isHolding() ? state : null;
        }

        /** Returns true if a player who walks straight on goes through the first portal and stays beyond. */
        boolean goesThrough(Simulation simulation, SimState start, double metres) {
            return goesThrough(simulation, start, metres, state -> PlayerInput.FORWARD);
        }

        /** Returns true if a player with the cube before it goes through the first portal and stays beyond. */
        boolean pushesThrough(SimState start, double metres) {
            return goesThrough(aided, start, metres + MORE_METRES, new Pusher());
        }

        private boolean goesThrough(
                Simulation simulation, SimState start, double metres, Function<SimState, PlayerInput> walker) {
            int last = (int) (TICKS_PER_SECOND * (metres / 2 + MORE_SECONDS));
            int crossings = 0;
            SimState state = start;
            for (int tick = 0; tick < last; tick++) {
                state = simulation.step(state, crossings > 0 ? PlayerInput.FORWARD : walker.apply(state));
                int now = state.world().trace().playerCrossed().length();
                if (crossings == 0 && now > 0) {
                    last = tick + 1 + (int) (AFTER_SECONDS * TICKS_PER_SECOND);
                }
                crossings += now;
            }
            stillHolds = state.world().holding().isHolding();
            return crossings % 2 == 1;
        }
    }

    /**
     * A player who pushes something towards the first portal: it looks at the portal, and steps back towards its middle
     * when it is stuck between the wall and what it pushes.
     */
    private static final class Pusher implements Function<SimState, PlayerInput> {
        /** Distance of the point behind the portal's centre at which it looks. */
        private static final double BEHIND_METRES = 0.3;

        private static final int STUCK_TICKS = TICKS_PER_SECOND / 3;
        private static final int BACK_TICKS = TICKS_PER_SECOND / 2;
        private static final double STUCK_METRES_PER_SECOND = 0.1;

        private int stuck;
        private int back;

        @Override
        public PlayerInput apply(SimState state) {
            Portal portal = state.world().portals().portal(0);
            Vec3 feet = state.player().feet();
            if (back > 0) {
                back--;
                int right = portal.across(feet.x(), feet.y(), feet.z()) > 0 ? -100 : 100;
                return PlayerInput.NONE.walking(-50, right);
            }
            stuck = state.player().velocity().length() < STUCK_METRES_PER_SECOND ? stuck + 1 : 0;
            if (stuck > STUCK_TICKS) {
                stuck = 0;
                back = BACK_TICKS;
            }
            Vec3 towards = portal.world(0, 0, -BEHIND_METRES).minus(feet);
            double turn = state.player().heading().yawRadiansTo(WalkInPlace.heading(towards));
            return PlayerInput.FORWARD.turning((int) Math.round(1000 * Math.toDegrees(turn)), 0);
        }
    }
}
