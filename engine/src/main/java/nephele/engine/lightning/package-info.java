/**
 * Lightning as a function of the time: when a strike begins, how bright it is, where its bolt goes. The seed and the
 * number of the strike give every random number, so any frame rate shows the same storm.
 */
package nephele.engine.lightning;
