/** The package table of DESIGN and the house style as rules, and planted violations that each rule must find. */
package nephele.architecture;
