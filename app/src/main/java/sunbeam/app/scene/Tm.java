package sunbeam.app.scene;
public final class Tm { static final java.util.Map<String,Long> t=new java.util.TreeMap<>(); static long last;
 public static long s(){return System.nanoTime();}
 public static void e(String n,long s){t.merge(n,System.nanoTime()-s,Long::sum);}
 static { Runtime.getRuntime().addShutdownHook(new Thread(()->t.forEach((k,v)->System.err.printf("%-20s %6.0f ms%n",k,v/1e6)))); }
 public static void mark(String n){ System.err.printf("@ %6.2f %s%n",(System.currentTimeMillis()-java.lang.management.ManagementFactory.getRuntimeMXBean().getStartTime())/1e3,n);} }
