/** Commands, and the options, outputs and certificates that they share; the larger ones have packages. Nothing else knows picocli. */
package sunbeam.app.cli;
